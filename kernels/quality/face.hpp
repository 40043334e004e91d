// The measures of kernels/quality/element.hpp for the faces of a mesh. A face in space is measured as it
// looks along the cross product of its diagonals (of a triangle: as it is): there its area counts as
// positive, so that no measure tells which side is up.
#pragma once

#include <array>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {

// The corners of a face in space, seen so that its first edge lies along the first axis. One without area is
// seen from somewhere, and has none there.
class FlatFace {
 public:
  FlatFace(const Mesh& mesh, FaceId f) {
    const Vec3 origin = mesh.point3(mesh.corner(f, 0));
    std::array<Vec3, 4> p{};
    const int count = mesh.corner_count(f);
    for (int k = 1; k < count; ++k) p[static_cast<std::size_t>(k)] = mesh.point3(mesh.corner(f, k)) - origin;
    const Vec3 normal = count == 3 ? cross(p[1], p[2]) : cross(p[2], p[3] - p[1]);
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

// Calls measure(a, b, c) or measure(a, b, c, d) with the corners of the face.
template <class Measure>
auto measure_face(const Mesh& mesh, FaceId f, Measure&& measure) {
  if (!mesh.planar()) {
    const FlatFace flat(mesh, f);
    if (mesh.corner_count(f) == 3) return measure(flat.corner(0), flat.corner(1), flat.corner(2));
    return measure(flat.corner(0), flat.corner(1), flat.corner(2), flat.corner(3));
  }
  const Vec2 a = mesh.point(mesh.corner(f, 0));
  const Vec2 b = mesh.point(mesh.corner(f, 1));
  const Vec2 c = mesh.point(mesh.corner(f, 2));
  if (mesh.corner_count(f) == 3) return measure(a, b, c);
  return measure(a, b, c, mesh.point(mesh.corner(f, 3)));
}

inline double scaled_jacobian(const Mesh& mesh, FaceId f) {
  return measure_face(mesh, f, [](auto... corners) { return scaled_jacobian(corners...); });
}

// The scaled Jacobian of every face, one for each slot; NaN for tombstones. In parallel.
[[nodiscard]] std::vector<double> scaled_jacobians(const Mesh& mesh);

}  // namespace quarry
