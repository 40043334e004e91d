// The verdict of kernels/quality/space_face.hpp on the faces of a mesh with normals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/space_face.hpp"

namespace quarry {

// scaled_jacobian_in_space of one face, in [-1, 1]; normals: by vertex, zero where one has no say.
[[nodiscard]] inline double face_verdict(const Mesh& mesh, Tag<VertexId, Vec3> normals, FaceId f) {
  std::array<SpacePoint, 4> corners;
  const auto count = static_cast<std::size_t>(mesh.corner_count(f));
  for (std::size_t k = 0; k < count; ++k) {
    const VertexId v = mesh.corner(f, static_cast<int>(k));
    corners[k] = {mesh.point3(v), normals[v]};
  }
  return scaled_jacobian_in_space(std::span(corners).first(count));
}

// The lowest of the faces around a vertex; 1 if there is none.
[[nodiscard]] inline double worst_around(const Mesh& mesh, Tag<VertexId, Vec3> normals, VertexId v) {
  double worst = 1;
  for_each_side_around(mesh, v,
                       [&](SideId s) { worst = std::min(worst, face_verdict(mesh, normals, s.face())); });
  return worst;
}

}  // namespace quarry
