// A face in space as it looks along its own normal: there the measures of the plane hold.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The normal is the cross product of the diagonals (of a triangle: of two edges). The first edge lies along
// the first axis, and the first corner in the origin. A face without area is seen from somewhere, and has
// none there.
class FlatFace {
 public:
  // Three or four corners.
  explicit FlatFace(std::span<const Vec3> corners) {
    std::array<Vec3, 4> p{};
    for (std::size_t k = 1; k < corners.size(); ++k) p[k] = corners[k] - corners[0];
    const Vec3 normal = corners.size() == 3 ? cross(p[1], p[2]) : cross(p[2], p[3] - p[1]);
    const double size = length(normal);
    const Vec3 up = size > 0 ? (1 / size) * normal : Vec3{0, 0, 1};
    Vec3 first = p[1] - dot(p[1], up) * up;
    if (!(length(first) > 0)) first = p[2] - dot(p[2], up) * up;
    const double along = length(first);
    if (!(along > 0)) return;
    first = (1 / along) * first;
    const Vec3 second = cross(up, first);
    for (std::size_t k = 0; k < 4; ++k) corners_[k] = {dot(p[k], first), dot(p[k], second)};
  }

  [[nodiscard]] Vec2 corner(std::size_t k) const { return corners_[k]; }

 private:
  std::array<Vec2, 4> corners_{};
};

[[nodiscard]] inline FlatFace flat_face(const Mesh& mesh, FaceId f) {
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(mesh.corner_count(f));
  for (std::size_t k = 0; k < count; ++k) corners[k] = mesh.point3(mesh.corner(f, static_cast<int>(k)));
  return FlatFace(std::span(corners).first(count));
}

}  // namespace quarry
