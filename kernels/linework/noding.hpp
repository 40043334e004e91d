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
// and nb are both shorter than ab (with h1, h2 the feet's distances from a and b: h1, h2 >= s, so |an|^2 <
// h1^2 + s^2 < (h1 + h2)^2), so that edges between finitely many nodes run out. Crossings add nodes only
// where none is near, and nodes may move once, onto the outline or an end onto a line. After a fixed number
// of rounds nothing is bent or added any more: the node in the way is merged into an end of the edge, and
// nodes run out.
void node_and_snap(PathNetwork& network, double snap, CleanCounts& counts, const Progress& progress);

}  // namespace quarry::linework
