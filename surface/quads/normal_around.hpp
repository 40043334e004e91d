// The direction that the faces around a vertex have on the whole.
#pragma once

#include "engine/mesh/mesh.hpp"

namespace quarry {

// Twice the area of a face, along its normal.
[[nodiscard]] inline Vec3 area_vector(const Mesh& mesh, FaceId f) {
  const Vec3 a = mesh.point3(mesh.corner(f, 0));
  const Vec3 b = mesh.point3(mesh.corner(f, 1));
  const Vec3 c = mesh.point3(mesh.corner(f, 2));
  return mesh.corner_count(f) == 3 ? cross(b - a, c - a) : cross(c - a, mesh.point3(mesh.corner(f, 3)) - b);
}

// The direction of the sum of their area vectors, which does not depend on where the vertex lies within them;
// (0, 0, 1) if that is nothing.
[[nodiscard]] inline Vec3 normal_around(const Mesh& mesh, VertexId v) {
  Vec3 sum;
  for_each_side_around(mesh, v, [&](SideId s) { sum = sum + area_vector(mesh, s.face()); });
  const double size = length(sum);
  return size > 0 ? (1 / size) * sum : Vec3{0, 0, 1};
}

}  // namespace quarry
