// How good a quad is, in the plane and in space alike: its smallest corner sine (the scaled Jacobian), seen
// along the normal of the quad itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/predicates.hpp"
#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/mesh/point_of.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/quality/element.hpp"

namespace quarry::matching {

// Calls work(Point()) with the kind of points that the mesh has.
template <class Work>
void with_points_of(const Mesh& mesh, Work&& work) {
  if (mesh.planar())
    work(Vec2());
  else
    work(Vec3());
}

// The sines of the corners of one quad. In space they are measured against the normal of the whole quad, the
// cross product of its diagonals. It points outwards for any quad made of two triangles that do, also where
// the quad is not convex, and needs no search for the nearest place of the surface.
template <class Point>
class CornerSines;

template <>
class CornerSines<Vec2> {
 public:
  CornerSines(Vec2 /*a*/, Vec2 /*b*/, Vec2 /*c*/, Vec2 /*d*/) {}
  [[nodiscard]] double operator()(Vec2 previous, Vec2 here, Vec2 next) const {
    return corner_scaled_jacobian(previous, here, next);
  }
};

template <>
class CornerSines<Vec3> {
 public:
  CornerSines(Vec3 a, Vec3 b, Vec3 c, Vec3 d) : normal_(cross(c - a, d - b)), size_(length(normal_)) {}
  [[nodiscard]] double operator()(Vec3 previous, Vec3 here, Vec3 next) const {
    const Vec3 out = next - here;
    const Vec3 back = previous - here;
    const double lengths = size_ * std::sqrt(dot(out, out) * dot(back, back));
    return lengths > 0 ? dot(normal_, cross(out, back)) / lengths : -1.0;
  }

 private:
  Vec3 normal_;
  double size_;
};

template <class Point>
[[nodiscard]] double quad_shape(Point a, Point b, Point c, Point d) {
  const CornerSines<Point> sine(a, b, c, d);
  return std::min(std::min(sine(d, a, b), sine(a, b, c)), std::min(sine(b, c, d), sine(c, d, a)));
}

template <class Point>
[[nodiscard]] Point centroid(Point a, Point b, Point c) {
  return a + (1.0 / 3.0) * ((b - a) + (c - a));
}

// The sine of a corner beyond 90 degrees below which it is flat.
inline constexpr double kFlat = 1e-6;

// True if each corner turns left (exact), and none is so flat that it does so by the last bits of its
// coordinates alone: nothing can be computed on such a quad.
[[nodiscard]] inline bool is_convex(const std::array<Vec2, 4>& quad, double flat = kFlat) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 before = quad[(i + 3) % 4], here = quad[i], after = quad[(i + 1) % 4];
    if (!(orient2d(before, here, after) > 0)) return false;
    if (dot(before - here, after - here) < 0 && corner_scaled_jacobian(before, here, after) < flat)
      return false;
  }
  return true;
}

// The corners of a quad of the plane.
[[nodiscard]] inline std::array<Vec2, 4> corners_of_quad(const Mesh& mesh, FaceId f) {
  return {mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)), mesh.point(mesh.corner(f, 2)),
          mesh.point(mesh.corner(f, 3))};
}

// is_convex of a face of the plane; of a triangle that it turns left.
[[nodiscard]] inline bool is_convex(const Mesh& mesh, FaceId f) {
  if (mesh.corner_count(f) == 3) return all_corners_turn_left(mesh, f);
  return is_convex(corners_of_quad(mesh, f));
}

}  // namespace quarry::matching
