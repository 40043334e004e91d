// The curves in which sheets of a surface meet.
#pragma once

#include <vector>

#include "surface/feature/edge_chains.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

// Every join once. Chains end where other than two joins meet, at rims, at borders between groups, and at
// corners (surface/feature/corners.hpp).
[[nodiscard]] std::vector<EdgeChain> join_chains(const RepairedSurface& repaired,
                                                 const FeatureOptions& corners);

}  // namespace quarry
