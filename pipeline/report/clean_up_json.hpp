// What clean-up did, as JSON: counts for each operator and each size class of patches, like Table 4 of Verma
// & Tautges 2011.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/operation/pass.hpp"
#include "kernels/cleanup/clean_up.hpp"

namespace quarry {

// The counts: the same on any number of threads.
[[nodiscard]] nlohmann::ordered_json clean_up_json(const CleanUpReport& report);

// The passes in it: one an operator, all sweeps together, and one a size class of patches, all commits
// together.
[[nodiscard]] std::vector<PassReport> passes_of(const CleanUpReport& report);

// Seconds of the same parts.
[[nodiscard]] nlohmann::ordered_json clean_up_times_json(const CleanUpReport& report);

}  // namespace quarry
