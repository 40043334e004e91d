// Splits in a triangle mesh: an edge at a point (2 -> 4, or 1 -> 2 on the boundary) and a face at a point (1
// -> 3).
#pragma once

#include "engine/mesh/constraint.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"

namespace quarry {

// True if every triangle that splitting the edge of s at p would make turns left (exact).
[[nodiscard]] bool can_split_edge(const Mesh& mesh, SideId s, Vec2 p);

// Lo's measure of the worst triangle that splitting the edge of s, or the face, at p would make.
[[nodiscard]] double worst_of_edge_split(const Mesh& mesh, SideId s, Vec2 p);
// The same in space, where it has no sign.
[[nodiscard]] double worst_of_edge_split(const Mesh& mesh, SideId s, Vec3 p);
// The smallest height of those triangles, in input units.
[[nodiscard]] double lowest_of_edge_split(const Mesh& mesh, SideId s, Vec2 p);
[[nodiscard]] double worst_of_face_split(const Mesh& mesh, FaceId f, Vec2 p);

// Claims the corners of the faces at the edge and announces the new vertex and faces.
void claim_split_edge(const Mesh& mesh, SideId s, Cavity& cavity);

// Splits the edge a-b of s at p. The new vertex bears the given support; both halves keep the constraint bit
// of the edge. can_split_edge must hold. Returns the new vertex.
VertexId split_edge(MeshEditor& editor, ConstraintTags tags, SideId s, Vec2 p, Support support, NewIds ids);
// The same in space.
VertexId split_edge(MeshEditor& editor, ConstraintTags tags, SideId s, Vec3 p, Support support, NewIds ids);

// True if p lies strictly inside the face (exact).
[[nodiscard]] bool can_split_face(const Mesh& mesh, FaceId f, Vec2 p);
void claim_split_face(const Mesh& mesh, FaceId f, Cavity& cavity);
// Joins p to the three corners of f. can_split_face must hold. Returns the new vertex.
VertexId split_face(MeshEditor& editor, ConstraintTags tags, FaceId f, Vec2 p, Support support, NewIds ids);

}  // namespace quarry
