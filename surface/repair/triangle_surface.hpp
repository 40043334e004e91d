// A triangulated surface as it comes: points and triangles, with nothing said about how they hang together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

using SurfaceTriangle = std::array<std::uint32_t, 3>;  // numbers of points

struct TriangleSurface {
  std::vector<Vec3> points;
  std::vector<SurfaceTriangle> triangles;
  std::vector<std::int32_t> groups;  // one a triangle
};

// Twice the area of a triangle along its normal, which is that of the side from which the corners turn left.
[[nodiscard]] inline Vec3 doubled_area(const TriangleSurface& surface, const SurfaceTriangle& t) {
  const Vec3 a = surface.points[t[0]];
  return cross(surface.points[t[1]] - a, surface.points[t[2]] - a);
}

// In square input units.
[[nodiscard]] inline double area_of(const TriangleSurface& surface) {
  double area = 0;
  for (const SurfaceTriangle& t : surface.triangles) area += 0.5 * length(doubled_area(surface, t));
  return area;
}

// Takes the other triangles out, with their groups; the order stays. keep(t): of triangle t.
template <class Keep>
void keep_triangles(TriangleSurface& surface, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!keep(t)) continue;
    surface.triangles[kept] = surface.triangles[t];
    surface.groups[kept++] = surface.groups[t];
  }
  surface.triangles.resize(kept);
  surface.groups.resize(kept);
}

}  // namespace quarry
