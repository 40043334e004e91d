// Narrow wedges between edges of a noded network, and their closing.
//
// What lies between two edges that leave a node at a small angle is narrower than the snapping distance for
// long, where elements would have to be as small as it. The second edge is to follow the first until they are
// as far apart, and to leave it there at a wider angle: a new node on the first, just nearer to the second
// than the snapping distance, bends that when the network is noded again, and a new one on the second, just
// farther away, keeps its further course.
#pragma once

#include <cstdint>

#include "kernels/linework/node_places.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Adds these nodes for the wedges narrower than a limit (radians) whose edges are long enough for them, where
// no other node is near; edges of the outline are never the second. Returns for how many wedges. The edges
// are those of the last build_edges().
std::uint32_t close_narrow_wedges(PathNetwork& network, NodePlaces& places, double snap, double limit);

}  // namespace quarry::linework
