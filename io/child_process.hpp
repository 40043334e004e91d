// Other programs, run without a shell and waited for.
#pragma once

#include <chrono>
#include <optional>

#include "engine/base/progress.hpp"
#include "io/running_child.hpp"

namespace quarry {

// Runs a program to its end and returns its exit status (128 + n where signal n ended it); none if there is
// no such program. Throws Error(kInterrupted) when the job is cancelled, Error(kBudget) where the time limit
// ends it, and Error(kOutput) where it cannot be started; it never outlives this call.
[[nodiscard]] std::optional<int> run_program(const ChildStart& start, const Progress& progress,
                                             std::chrono::seconds time_limit = std::chrono::seconds(600));

}  // namespace quarry
