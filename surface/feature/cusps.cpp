#include "surface/feature/cusps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "engine/parallel/parallel.hpp"
#include "surface/feature/point_incidence.hpp"

namespace quarry {
namespace {

constexpr double kMostAngle = 1.5 * std::numbers::pi;
// The radii of the spheres, in sizes: what is no cusp shows it early, as a rule.
constexpr std::array kRadii = {1.0 / 16, 1.0 / 4, 1.0};
// Where more triangles than that lie within the sphere, they tell nothing at the scale of elements.
constexpr std::size_t kMostTriangles = 20000;

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// Numbers in the order in which they were added, each once.
struct Visited {
  std::vector<std::uint32_t> list;
  std::vector<std::uint8_t> has;

  explicit Visited(std::size_t numbers) : has(numbers, 0) {}
  bool add(std::uint32_t number) {
    if (has[number] != 0) return false;
    has[number] = 1;
    list.push_back(number);
    return true;
  }
  void begin_anew() {
    for (const std::uint32_t number : list) has[number] = 0;
    list.clear();
  }
};

class CuspFinder {
 public:
  CuspFinder(const TriangleSurface& surface, std::span<const std::uint8_t> bound, double size)
      : surface_(surface),
        bound_(bound),
        size_(size),
        at_(surface.points.size(), surface.triangles.size(),
            [&](std::size_t t) { return surface.triangles[t]; }),
        points_(surface.points.size()),
        triangles_(surface.triangles.size()) {}

  std::vector<std::uint32_t> run() {
    std::vector<Cusp> found;
    for (const std::uint32_t p :
         parallel::filter_indices(surface_.points.size(), [&](std::size_t i) { return is_pointed(i); }))
      if (const auto turn = turn_of(p)) found.push_back({*turn, p});
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> cusps;
    for (const Cusp& cusp : found)
      if (std::none_of(cusps.begin(), cusps.end(), [&](std::uint32_t other) {
            return length(surface_.points[other] - surface_.points[cusp.point]) < size_;
          }))
        cusps.push_back(cusp.point);
    std::sort(cusps.begin(), cusps.end());
    return cusps;
  }

 private:
  struct Cusp {
    double turn;
    std::uint32_t point;
    auto operator<=>(const Cusp&) const = default;
  };

  [[nodiscard]] Vec3 place(std::uint32_t p) const { return surface_.points[p]; }

  [[nodiscard]] bool is_pointed(std::size_t i) const {
    const auto p = static_cast<std::uint32_t>(i);
    if (bound_[p] != 0 || at_.around(p).empty()) return false;
    double angle = 0;
    for (const std::uint32_t t : at_.around(p)) {
      const SurfaceTriangle& corners = surface_.triangles[t];
      const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), p) - corners.begin());
      angle += angle_between(place(corners[(k + 1) % 3]) - place(p), place(corners[(k + 2) % 3]) - place(p));
    }
    return angle <= kMostAngle;
  }

  // Of the course in the largest sphere; none if it is no cusp.
  std::optional<double> turn_of(std::uint32_t p) {
    double turn = 0;
    for (const double radius : kRadii) {
      const auto course = course_around(p, radius * size_);
      // A sphere that holds the whole part tells nothing.
      if (!course || !(*course > 0) || *course > kMostAngle) return std::nullopt;
      turn = *course;
    }
    return turn;
  }

  // How far the line in which a sphere cuts the triangles that hang together around its middle turns, as the
  // middle sees it; none if a feature, or too much, lies inside.
  std::optional<double> course_around(std::uint32_t middle, double radius) {
    const auto inside = [&](std::uint32_t p) { return length(place(p) - place(middle)) < radius; };
    points_.begin_anew();
    triangles_.begin_anew();
    points_.add(middle);
    double turn = 0;
    for (std::size_t i = 0; i < points_.list.size(); ++i)
      for (const std::uint32_t t : at_.around(points_.list[i])) {
        if (!triangles_.add(t)) continue;
        if (triangles_.list.size() > kMostTriangles) return std::nullopt;
        turn += turn_in(surface_.triangles[t], middle, radius);
        for (const std::uint32_t p : surface_.triangles[t])
          if (inside(p) && points_.add(p) && bound_[p] != 0) return std::nullopt;
      }
    return turn;
  }

  // Between the two sides on which a triangle leaves the sphere.
  [[nodiscard]] double turn_in(const SurfaceTriangle& t, std::uint32_t middle, double radius) const {
    std::array<Vec3, 3> out;
    std::array<bool, 3> inside;
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = place(t[k]) - place(middle);
      inside[k] = length(out[k]) < radius;
    }
    std::array<Vec3, 2> crossings;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (inside[k] == inside[next]) continue;
      crossings[count++] =
          inside[k] ? crossing(out[k], out[next], radius) : crossing(out[next], out[k], radius);
    }
    return count == 2 ? angle_between(crossings[0], crossings[1]) : 0;
  }

  // Where the way from a point inside to one outside leaves a sphere around the origin.
  [[nodiscard]] static Vec3 crossing(Vec3 from, Vec3 to, double radius) {
    const Vec3 way = to - from;
    const double squared = dot(way, way);
    const double half = dot(from, way);
    const double root = std::sqrt(std::max(0.0, half * half + squared * (radius * radius - dot(from, from))));
    return from + ((root - half) / squared) * way;
  }

  const TriangleSurface& surface_;
  std::span<const std::uint8_t> bound_;
  double size_;
  PointIncidence at_;           // triangles
  Visited points_, triangles_;  // by a sphere
};

}  // namespace

std::vector<std::uint32_t> find_cusps(const TriangleSurface& surface, std::span<const std::uint8_t> bound,
                                      double size) {
  if (!(size > 0)) return {};
  return CuspFinder(surface, bound, size).run();
}

}  // namespace quarry
