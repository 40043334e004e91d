// Snapping and noding to a fixed point: afterwards edges meet at nodes only, and no node with an edge lies
// nearer than the snapping distance to an edge that does not end there.
#pragma once

#include "engine/base/progress.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Why it ends. A node n nearer than s = snap to an edge ab bends it. While all nodes are sqrt(2) s apart, an
// and nb are both shorter than ab (with h1, h2 >= s the distances of the foot from a and b, |an|^2 < h1^2 +
// s^2 <= (h1 + h2)^2), so that edges between finitely many nodes run out. Crossings and anchors add nodes
// only where none is near, which ends too. Nodes move at most twice: the end of a single line onto a line, if
// that leaves it apart from others, and any node onto the outline, where it swallows those that it comes too
// near to.
//
// Why lines stay near their raw course. One bend after another may lead a path away from it. A path that is
// farther than the budget (or 3 s, if that is less) is laid anew there, from node to nearest node along the
// raw line, with new nodes where none is nearer than sqrt(2) s. Such edges all but belong to the Delaunay
// triangulation of the nodes: they hardly cross, nearly all are shorter than 2 s, and those cannot be bent
// any more, for a foot would have to be s away from both ends. Where lines are that dense, the result is thus
// as good as one on a lattice of that spacing, and as sure to be found.
//
// What is noded has its narrow wedges closed (narrow_wedges.hpp) and is noded again, a few times.
//
// budget: how far a line may be from its raw course in the end. Throws Error(kGeometry) with the place if the
// rounds run out all the same.
void node_and_snap(PathNetwork& network, const CleanOptions& options, double budget, CleanCounts& counts,
                   const Progress& progress);

}  // namespace quarry::linework
