// A mesh cut open along its constraints. Each constrained side becomes a boundary side, and each vertex on
// constraints gets one copy for each sector that they leave around it. What works inside a boundary then
// keeps every constraint without knowing of it: a dangling line is a slit, its tip one boundary vertex with a
// sector of a full turn.
#pragma once

#include <cstdint>
#include <span>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The vertex tag (VertexId) of a mesh that is cut open: for the copies of one vertex the first of them, which
// keeps the number of the vertex; invalid for a vertex in one piece, and so for vertices to come.
inline constexpr const char* kWholeTag = "whole";

// The vertex that v is a copy of, or v itself.
[[nodiscard]] inline VertexId whole_of(const Tag<VertexId, VertexId>& whole, VertexId v) {
  return whole[v].valid() ? whole[v] : v;
}

// Cuts along all constrained sides; both sides of an edge must agree. Copies have the point and the support
// of their vertex, and new numbers in the order of the vertices they come from. Constraint bits stay. The
// mesh must not be cut open already.
void cut_open(Mesh& mesh, ConstraintTags tags);

// Joins again what lies along the inside of lines: the edges both of whose ends slide, or are nodes that may
// be in one piece (nodes, by vertex of the mesh before it was cut open; at most one edge of such a node may
// lead to one that may not). The vertices of these edges are in one piece then; an edge that ends at another
// node stays open, and what is next to it is the tip of a slit. sew() works afterwards, too.
void sew_pieces(Mesh& mesh, ConstraintTags tags, std::span<const std::uint8_t> nodes);

// The inverse, after any operation that has kept the boundary sides with their end points: joins the sides
// that were one edge, puts the first copies in the place of all, and removes the tag. Copies become
// tombstones. A vertex has the point of its first copy.
void sew(Mesh& mesh, ConstraintTags tags);

}  // namespace quarry
