// An order of the dual's arcs in which the spanning forest begins with good pairs of triangles and joins the
// triangles that are left single along short alternating ways. The join of such a forest keeps nearly all of
// these pairs: it changes them along those ways alone, where a forest ordered by the shape of quads sends the
// parity of every irregular place across the mesh.
//   J. Edmonds: Paths, trees, and flowers. Canad. J. Math. 17, 1965 (alternating trees; no blossoms here).
#pragma once

#include <span>
#include <vector>

#include "kernels/matching/join.hpp"

namespace quarry {

struct ShortWayOptions {
  // The worst quad that triangles are paired for at first.
  double smallest_shape = 0.5;
};

// The worth of each arc for maximum_spanning_forest, for each side slot; kNoArc where there is no arc.
// shapes: as pair_shapes gives them. First come pairs, matched greedily, the best one of both its triangles
// first; then the arcs of alternating trees that grow from the single triangles at the same speed; then arcs
// between trees, those that close an alternating way first, by its length. In parallel, the same on any
// number of threads.
[[nodiscard]] std::vector<float> short_way_worths(const Mesh& mesh, std::span<const float> shapes,
                                                  const ShortWayOptions& options);

}  // namespace quarry
