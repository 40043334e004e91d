#include "surface/feature/sharpness.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/parallel/parallel.hpp"

namespace quarry {

std::vector<double> dihedral_angles(const TriangleSurface& surface, const SurfaceEdges& edges) {
  std::vector<double> angles(edges.count(), 0);
  parallel::for_each(edges.count(), [&](std::size_t e) {
    const auto sides = edges.sides(e);
    if (sides.size() != 2) return;
    const Vec3 n = doubled_area(surface, surface.triangles[sides[0] / 3]);
    const Vec3 m = doubled_area(surface, surface.triangles[sides[1] / 3]);
    if (n == Vec3() || m == Vec3()) return;
    angles[e] = std::atan2(length(cross(n, m)), dot(n, m));
  });
  return angles;
}

double find_sharpness(const TriangleSurface& surface, const SurfaceEdges& edges,
                      const std::vector<double>& angles) {
  constexpr double kFirst = 30, kLast = 60, kStep = 5;
  constexpr double kContrast = 2;
  // Length by whole degrees.
  std::array<double, 181> lengths{};
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = SurfaceEdges::ends(surface, edges.sides(e)[0]);
    const auto degree = static_cast<std::size_t>(angles[e] * 180 / std::numbers::pi);
    lengths[degree] += length(surface.points[b] - surface.points[a]);
  }
  const auto between = [&](double from, double to) {
    double sum = 0;
    for (std::size_t d = 0; d < lengths.size(); ++d)
      if (static_cast<double>(d) >= from && static_cast<double>(d) < to) sum += lengths[d];
    return sum;
  };
  for (double angle = kFirst; angle <= kLast; angle += kStep) {
    const double sharp = between(angle, 181);
    if (sharp > 0 && sharp >= kContrast * between(angle / 2, angle)) return angle;
  }
  return kKnifeEdge;
}

}  // namespace quarry
