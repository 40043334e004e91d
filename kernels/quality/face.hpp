// The measures of kernels/quality/element.hpp for the faces of a mesh. A face in space is measured as it
// looks along the cross product of its diagonals (of a triangle: as it is): there its area counts as
// positive, so that no measure tells which side is up.
#pragma once

#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/flat_face.hpp"

namespace quarry {

// Calls measure(a, b, c) or measure(a, b, c, d) with the corners of the face.
template <class Measure>
auto measure_face(const Mesh& mesh, FaceId f, Measure&& measure) {
  if (!mesh.planar()) {
    const FlatFace flat = flat_face(mesh, f);
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
