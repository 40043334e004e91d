// Snapping and noding to a fixed point: afterwards edges meet at nodes only, and no node with an edge lies
// nearer than the snapping distance to an edge that does not end there.
#pragma once

#include "engine/base/progress.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Builds the network: raw points cluster to nodes at least sqrt(2) * snap apart, with the coordinates of one
// of them; points of the outline come first, then ends of lines, then the rest, each in reading order.
[[nodiscard]] PathNetwork cluster_points(std::vector<RawLine> raw, double snap);

// Why it ends. A node n nearer than s = snap to an edge ab bends it. While all nodes are sqrt(2) s apart, an
// and nb are both shorter than ab (with h1, h2 >= s the distances of the foot from a and b, |an|^2 < h1^2 +
// s^2 <= (h1 + h2)^2), so that edges between finitely many nodes run out. Crossings add nodes only where none
// is near. Nodes move at most twice: the end of a single line onto a line, if that leaves it apart from
// others, and any node onto the outline, where it swallows those that it comes too near to. As rounding and
// crossings are not in this argument, hits that go on for several rounds are settled by merging nodes, and
// after a fixed number of rounds everything is: then every round has fewer nodes than the one before.
void node_and_snap(PathNetwork& network, double snap, CleanCounts& counts, const Progress& progress);

}  // namespace quarry::linework
