// Points where a domain touches itself: two polygons that share a corner, a hole that meets the outline. The
// faces around such a point form several fans, and the store knows one fan a vertex, so each fan has a vertex
// of its own while the mesh is made. Files hold the point once.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The vertex tag (uint8, 1: yes) of vertices that share their point with others and are one point in a file.
inline constexpr const char* kPinchTag = "pinch";

struct FanTwin {
  VertexId vertex, twin;  // of the first fan, and that of another
};

// By kPinchTag, in the order of the twins: the vertex is the one of smallest id at their point.
[[nodiscard]] std::vector<FanTwin> pinch_twins(const Mesh& mesh);

// Gives each fan beyond the first at a boundary vertex a new vertex with the same point. For meshes whose
// side_of sees the fan with the boundary side of smallest number, as remove_outside and
// rebuild_sides_of_vertices leave them.
std::vector<FanTwin> split_fans(Mesh& mesh);

// The same; the new vertices have the same support as well. Returns their number.
std::size_t split_pinches(Mesh& mesh, ConstraintTags tags);

// Sets kPinchTag at the boundary vertices that are bound to the same node. Without any, the mesh gets no tag.
void mark_pinches(Mesh& mesh, ConstraintTags tags);

}  // namespace quarry
