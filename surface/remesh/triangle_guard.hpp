// What each change of a surface mesh must leave standing: triangles that face the way the surface does.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/quality/space_face.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

[[nodiscard]] inline Vec3 unit_normal(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = cross(b - a, c - a);
  const double size = length(n);
  return size > 0 ? (1 / size) * n : Vec3();
}

class TriangleGuard {
 public:
  TriangleGuard(const SurfaceModel& model, Tag<VertexId, Vec3> normals, double least_cosine)
      : model_(&model), normals_(normals), least_(least_cosine) {}

  // True if the triangle has an area, and turns little from the surface at those of its corners that know; if
  // all of them lie on features, so that none does, from the surface about its middle. Points are given
  // apart: a corner may be about to move.
  [[nodiscard]] bool faces_up(const std::array<VertexId, 3>& corners,
                              const std::array<Vec3, 3>& points) const {
    const Vec3 n = unit_normal(points[0], points[1], points[2]);
    if (n == Vec3()) return false;
    return std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return agrees(n, normals_[v]); }) &&
           (knows(corners) || faces_along_surface(n, points));
  }
  // Whether the surface's normal is known at one of the vertices.
  template <std::size_t N>
  [[nodiscard]] bool knows(const std::array<VertexId, N>& vertices) const {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](VertexId v) { return !(normals_[v] == Vec3()); });
  }
  // Whether some of the surface faces along the normal of a triangle, of what is about as near to its middle
  // as the nearest point is (to a tenth of the triangle's size).
  [[nodiscard]] bool faces_along_surface(Vec3 normal, const std::array<Vec3, 3>& points) const {
    const Vec3 middle = (1.0 / 3) * (points[0] + points[1] + points[2]);
    double size = 0;
    for (const Vec3 p : points) size = std::max(size, length(p - middle));
    return model_->faces_along(middle, normal, 0.1 * size);
  }
  // Two directions, of which one may be unknown (zero).
  [[nodiscard]] bool agrees(Vec3 n, Vec3 m) const { return m == Vec3() || dot(n, m) >= least_; }

 private:
  const SurfaceModel* model_;
  Tag<VertexId, Vec3> normals_;
  double least_;
};

}  // namespace quarry
