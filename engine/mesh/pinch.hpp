// Points where a domain touches itself: two polygons that share a corner, a hole that meets the outline. The
// faces around such a point form several fans, and the store knows one fan a vertex, so each fan has a vertex
// of its own while the mesh is made. Files hold the point once.
#pragma once

#include <cstddef>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The vertex tag (uint8, 1: yes) of vertices that share their point with others and are one point in a file.
inline constexpr const char* kPinchTag = "pinch";

// Gives each fan beyond the first at a vertex a new vertex with the same point and support. For meshes as
// remove_outside leaves them, whose side_of sees the fan with the boundary side of smallest number. Returns
// the number of new vertices.
std::size_t split_pinches(Mesh& mesh, ConstraintTags tags);

// Sets kPinchTag at the boundary vertices that are bound to the same node. Without any, the mesh gets no tag.
void mark_pinches(Mesh& mesh, ConstraintTags tags);

}  // namespace quarry
