// The curves in which sheets of a surface meet.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/feature/corners.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

// Points in a row, two joins at each but the ends. Of a closed course the last point is the first.
struct JoinChain {
  std::vector<std::uint32_t> points;
  ChainEnds ends = ChainEnds::kNodes;
};

// Every join once. Chains end where other than two joins meet, at rims, at borders between groups, and at
// corners (surface/feature/corners.hpp).
[[nodiscard]] std::vector<JoinChain> join_chains(const RepairedSurface& repaired,
                                                 const FeatureOptions& corners);

}  // namespace quarry
