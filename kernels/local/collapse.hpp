// Edge collapse in a triangle mesh.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"

namespace quarry {

// True if the mesh stays one without double faces or edges when a goes into b: both have no other neighbours
// in common than the corners across their edge, these keep at least three faces (on the boundary: one), and
// what is joined is not two boundaries. Reads the stars of both and of the corners across. Support is not
// looked at.
[[nodiscard]] bool can_collapse(const Mesh& mesh, VertexId a, VertexId b);

// Claims both vertices and their links.
void claim_collapse(const Mesh& mesh, VertexId a, VertexId b, Cavity& cavity);

// Takes a away: its edge to b with the one or two faces there goes, and its other faces get b in its place.
// The two sides that become one on each side are constrained if one of them was. can_collapse must hold.
void collapse_edge(MeshEditor& editor, ConstraintTags tags, VertexId a, VertexId b);

}  // namespace quarry
