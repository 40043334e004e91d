// Edges of a surface in a row.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/feature/corners.hpp"

namespace quarry {

// Of a closed course the last point is the first.
struct EdgeChain {
  std::vector<std::uint32_t> points;
  std::uint32_t first_edge = 0;
  ChainEnds ends = ChainEnds::kNodes;
};

// All edges, each once: first in chains that begin and end at nodes, then in closed courses without a node,
// each from its smallest point on. edges: the points of each. node: by point, nonzero where chains end, as
// they must wherever other than two edges meet.
[[nodiscard]] std::vector<EdgeChain> edge_chains(std::span<const std::array<std::uint32_t, 2>> edges,
                                                 std::span<const std::uint8_t> node);

}  // namespace quarry
