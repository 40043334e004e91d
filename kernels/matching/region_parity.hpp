// Makes every region of a constrained triangle mesh even, so that its triangles can be merged into quads
// without crossing a constraint. Halving an edge between two regions changes the parity of both, halving an
// outer edge that of one: the edges to halve are a T-join of the odd regions in the graph of regions, with
// the outside as a node where outer edges may be halved.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "kernels/matching/join.hpp"

namespace quarry {

struct ParityReport {
  std::uint64_t regions = 0;
  std::uint64_t odd_regions = 0;
  std::uint64_t halved_edges = 0;
};

// One side of each edge to halve, ascending. root: the face that stands for the region of each face (see
// SpanningForest). Between two regions the longest edge is taken among those whose halves are valid and that
// leave no triangle with two constrained sides; the tree along which parity is moved is that of the shortest
// ways to the outside. Throws Error(kGeometry) that names a place of the component, the number of its
// boundary sides and the remedy, if outer edges may not be halved and a component is odd.
[[nodiscard]] std::vector<SideId> edges_to_halve(const Mesh& mesh, ConstraintTags tags,
                                                 const IdVector<FaceId, FaceId>& root, bool keep_boundary,
                                                 ParityReport& report);

// Halves edges of a planar mesh. New vertices lie on the piece of a constrained edge and slide on it; those
// of other boundary edges are fixed. Constraint bits and boundary sides stay what they are.
void halve_edges(Mesh& mesh, ConstraintTags tags, const NodedLines& lines, std::span<const SideId> sides);

}  // namespace quarry
