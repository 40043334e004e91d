// Edge flip in a triangle mesh.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"

namespace quarry {

// The four vertices of the two triangles at an interior edge a-b: c is opposite on the left, d on the right.
struct EdgeDiamond {
  VertexId a, b, c, d;
};
// s must have a neighbour.
[[nodiscard]] EdgeDiamond diamond_of(const Mesh& mesh, SideId s);

// True if both triangles that a flip of s would make turn left (exact).
[[nodiscard]] bool can_flip(const Mesh& mesh, SideId s);

// Claims what flip_edge touches: the four vertices of the diamond.
void claim_flip(const Mesh& mesh, SideId s, Cavity& cavity);

// Replaces the edge of s, a-b, by c-d. Face of s becomes (c, a, d), the one across (d, b, c). The edge must
// be unconstrained and can_flip must hold; constraint bits of the other four sides are kept. Returns the side
// c -> d.
SideId flip_edge(MeshEditor& editor, ConstraintTags tags, SideId s);

}  // namespace quarry
