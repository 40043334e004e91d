// How much work jobs are, guessed before they are run.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "engine/base/progress.hpp"

namespace quarry {

// guess(i) for each i below count. It reads input that nobody has looked at yet, so it runs in a process of
// its own: none where it crashes, throws, gives no number above 0, or takes longer than it is worth (half a
// second; ten for all together). To be called while this process has one thread.
[[nodiscard]] std::vector<std::optional<double>> guess_weights(
    std::size_t count, const std::function<double(std::size_t)>& guess, const Progress& progress);

}  // namespace quarry
