// What keeps a network from being noded: nodes too near to edges, and edges that cross.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// A node nearer than snap to an edge that does not end there.
struct Hit {
  NodeId node;
  std::uint32_t edge;
  double squared;  // distance
};

struct Crossing {
  std::uint32_t first;
  std::uint32_t second;
};

// segments: those of the network's edges; grid: of them. Hits come by node, then edge; crossings by first,
// then second edge, the first being the smaller number.
[[nodiscard]] std::vector<Hit> find_hits(const PathNetwork& network, const std::vector<Segment>& segments,
                                         const SegmentGrid& grid, double snap);
[[nodiscard]] std::vector<Crossing> find_crossings(const std::vector<Segment>& segments,
                                                   const SegmentGrid& grid);

}  // namespace quarry::linework
