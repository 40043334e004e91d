// The place of a vertex in the terms that an algorithm is written in, for code that is the same in the plane
// and in space.
#pragma once

#include <type_traits>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// Point: Vec2 on planar meshes; in space Vec3, or SpacePoint, with the normal, on meshes that have normals.
// In input units.
template <class Point>
[[nodiscard]] Point point_of(const Mesh& mesh, VertexId v) {
  if constexpr (std::is_same_v<Point, Vec2>)
    return mesh.point(v);
  else if constexpr (std::is_same_v<Point, Vec3>)
    return mesh.point3(v);
  else
    return {mesh.point3(v), mesh.normals()[v]};
}

}  // namespace quarry
