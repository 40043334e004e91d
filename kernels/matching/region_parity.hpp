// Makes every region of a constrained triangle mesh even, so that its triangles can be merged into quads
// without crossing a constraint. Halving an edge between two regions changes the parity of both, halving an
// outer edge that of one: the edges to halve are a T-join of the odd regions in the graph of regions, with
// the outside as a node where outer edges may be halved (kernels/matching/t_join).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/local/split.hpp"
#include "kernels/matching/join.hpp"

namespace quarry {

struct ParityReport {
  std::uint64_t regions = 0;
  std::uint64_t odd_regions = 0;
  std::uint64_t halved_edges = 0;
};

// Whether an outer edge, seen from its only face, may be halved.
using MayHalveOuter = std::function<bool(SideId)>;

// One side of each edge to halve, ascending. In the plane and in space. root: the face that stands for the
// region of each face (see SpanningForest). Between two regions the longest edge is taken among those whose
// halves are valid and that leave no triangle with two constrained sides; in all as few edges as cheap_t_join
// finds, and of as few the longest. Throws Error(kGeometry) that names a place of the component, the number
// of its boundary sides and the remedy, if none of its outer edges may be halved and a component is odd.
[[nodiscard]] std::vector<SideId> edges_to_halve(const Mesh& mesh, ConstraintTags tags,
                                                 const IdVector<FaceId, FaceId>& root,
                                                 const MayHalveOuter& may_halve_outer, ParityReport& report);

// How many regions have an odd number of triangles.
[[nodiscard]] std::uint64_t count_odd_regions(const Mesh& mesh, const IdVector<FaceId, FaceId>& root);

// Halves edges of a planar mesh. New vertices lie on the piece of a constrained edge and slide on it; those
// of other boundary edges are fixed. Constraint bits and boundary sides stay what they are.
void halve_edges(Mesh& mesh, ConstraintTags tags, const NodedLines& lines, std::span<const SideId> sides);

// Halves edges one after the other where middle_of(SideId) says: a point of the mesh's kind and the support
// of the new vertex.
template <class MiddleOf>
void halve_edges_at(Mesh& mesh, ConstraintTags tags, std::span<const SideId> sides,
                    const MiddleOf& middle_of) {
  // Halving one edge renumbers the sides of its faces: the others are remembered by their ends.
  std::vector<std::pair<VertexId, VertexId>> ends;
  for (const SideId s : sides) ends.emplace_back(mesh.origin(s), mesh.target(s));
  for (const auto& [a, b] : ends) {
    const SideId s = mesh.find_side(a, b);
    const auto [middle, support] = middle_of(s);
    MeshEditor editor(mesh);
    const std::size_t faces = mesh.neighbour(s).valid() ? 2 : 1;
    const NewIds ids{mesh.grow_vertices(1), mesh.grow_faces(faces)};
    (void)split_edge(editor, tags, s, middle, support, ids);
  }
}

}  // namespace quarry
