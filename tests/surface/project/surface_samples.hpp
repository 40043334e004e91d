// Surfaces to ask for closest points and rays, and the answers that looking at every triangle gives.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"
#include "io/mesh/obj_format.hpp"
#include "surface/project/triangle_blocks.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry::test {

inline constexpr std::uint64_t kSeed = 5;

using Triangle = std::array<std::uint32_t, 3>;

struct Surface {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  [[nodiscard]] Box3 box() const {
    Box3 box;
    for (const Vec3 p : points) box.extend(p);
    return box;
  }
};

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * uniform01(seed_, counter_++); }
  Vec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  std::uint32_t below(std::size_t limit) {
    return static_cast<std::uint32_t>(uniform01(seed_, counter_++) * static_cast<double>(limit));
  }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

// Triangles of all sizes that have nothing to do with each other, in a cube of side 20 about a point.
inline Surface soup(std::uint64_t seed, std::size_t count, Vec3 middle = {}) {
  Draws draws(seed);
  Surface surface;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = middle + draws.in_cube(10);
    const double size = std::exp(draws.uniform(-4, 1));
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    for (int corner = 0; corner < 3; ++corner) surface.points.push_back(at + draws.in_cube(size));
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  return surface;
}

// Unit squares with their middle points, heights 0 and 1 by turns and 0.5 in the middle: everything is a
// dyadic number, and from points above the lattice several triangles are exactly equally near.
inline Surface egg_box(std::uint32_t side) {
  Surface surface;
  const std::uint32_t row = side + 1;
  for (std::uint32_t y = 0; y < row; ++y)
    for (std::uint32_t x = 0; x < row; ++x)
      surface.points.push_back({1.0 * x, 1.0 * y, (x + y) % 2 == 0 ? 0.0 : 1.0});
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto middle = static_cast<std::uint32_t>(surface.points.size());
      surface.points.push_back({x + 0.5, y + 0.5, 0.5});
      const std::uint32_t a = y * row + x;
      const std::array<std::uint32_t, 4> ring{a, a + 1, a + row + 1, a + row};
      for (std::size_t i = 0; i < 4; ++i) surface.triangles.push_back({ring[i], ring[(i + 1) % 4], middle});
    }
  }
  return surface;
}

// The surface of a cube of `side` lattice cells a side, with corners at whole numbers; normals outwards.
inline Surface lattice_cube(std::uint32_t side, Vec3 low = {}) {
  Surface surface;
  const auto add_side = [&](auto&& point_at) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    for (std::uint32_t v = 0; v <= side; ++v)
      for (std::uint32_t u = 0; u <= side; ++u) surface.points.push_back(low + point_at(1.0 * u, 1.0 * v));
    for (std::uint32_t v = 0; v < side; ++v) {
      for (std::uint32_t u = 0; u < side; ++u) {
        const std::uint32_t a = first + v * (side + 1) + u;
        surface.triangles.push_back({a, a + 1, a + side + 2});
        surface.triangles.push_back({a, a + side + 2, a + side + 1});
      }
    }
  };
  const double far = side;
  add_side([&](double u, double v) { return Vec3{v, u, 0}; });
  add_side([&](double u, double v) { return Vec3{u, v, far}; });
  add_side([&](double u, double v) { return Vec3{u, 0, v}; });
  add_side([&](double u, double v) { return Vec3{v, far, u}; });
  add_side([&](double u, double v) { return Vec3{0, v, u}; });
  add_side([&](double u, double v) { return Vec3{far, u, v}; });
  return surface;
}

// A sphere of radius 1 about a point, by parallels and meridians, with bumps; closed, normals outwards.
inline Surface bumpy_sphere(std::uint32_t parallels, std::uint32_t meridians, double bump = 0,
                            Vec3 middle = {}) {
  Surface surface;
  const auto point = [&](double theta, double phi) {
    const double radius = 1 + bump * std::sin(7 * theta) * std::sin(5 * phi);
    return middle +
           radius * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  };
  surface.points.push_back(point(0, 0));
  for (std::uint32_t i = 1; i < parallels; ++i)
    for (std::uint32_t j = 0; j < meridians; ++j)
      surface.points.push_back(point(std::numbers::pi * i / parallels, 2 * std::numbers::pi * j / meridians));
  const auto south = static_cast<std::uint32_t>(surface.points.size());
  surface.points.push_back(point(std::numbers::pi, 0));
  for (std::uint32_t j = 0; j < meridians; ++j) {
    const std::uint32_t next = (j + 1) % meridians;
    surface.triangles.push_back({0, 1 + j, 1 + next});
    for (std::uint32_t i = 0; i + 2 < parallels; ++i) {
      const std::uint32_t above = 1 + i * meridians, below = above + meridians;
      surface.triangles.push_back({above + j, below + j, below + next});
      surface.triangles.push_back({above + j, below + next, above + next});
    }
    const std::uint32_t last = south - meridians;
    surface.triangles.push_back({last + j, south, last + next});
  }
  return surface;
}

// Surfaces as published by others, which are not part of this project.
inline const std::string kSurfaceFolder = "../shared/data/surface/";

inline Surface read_surface(const std::string& path) {
  const ReadCells cells = read_obj(path);
  Surface surface;
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    surface.points.push_back({cells.x[i], cells.y[i], cells.z[i]});
  for (const FaceCorners& face : cells.faces)
    surface.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
  return surface;
}

// Queries of every kind: at corners, above edges and middles of triangles, near, in the box, and far away.
inline std::vector<Vec3> queries(const Surface& surface, std::uint64_t seed, std::size_t count) {
  Draws draws(seed);
  const Box3 box = surface.box();
  const Vec3 middle = box.low + 0.5 * (box.high - box.low);
  const double size = box.longest_side();
  std::vector<Vec3> result;
  while (result.size() < count) {
    const Triangle& t = surface.triangles[draws.below(surface.triangles.size())];
    const Vec3 a = surface.points[t[0]], b = surface.points[t[1]], c = surface.points[t[2]];
    const Vec3 normal = cross(b - a, c - a);
    result.push_back(a);
    result.push_back(a + 0.5 * (b - a));
    result.push_back(a + 0.5 * (b - a) + draws.uniform(-1, 1) * normal);
    result.push_back((1.0 / 3) * (a + b + c) + draws.uniform(-1, 1) * normal);
    result.push_back(a + draws.in_cube(1e-3 * size));
    result.push_back(middle + draws.in_cube(size));
    result.push_back(middle + draws.in_cube(1e3 * size));
  }
  return result;
}

// What looking at every triangle gives. ties: how many triangles are as near as the answer.
struct LookedAtAll {
  SurfacePoint best;
  int ties = 0;
};

inline LookedAtAll look_at_all(const Surface& surface, Vec3 p, const ClosestQuery& query = {}) {
  LookedAtAll all;
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const OrderedTriangle triangle(surface.points, surface.triangles[i]);
    const TrianglePoint<double> point = closest_on_triangle(p, triangle.corners);
    const bool turned =
        query.least_cosine > -1 && !(dot(triangle.unit_normal(), query.normal) >= query.least_cosine);
    if (turned || !query.keep(TriangleId(i)) || point.squared_distance > query.radius * query.radius)
      continue;
    if (point.squared_distance == all.best.squared_distance) ++all.ties;
    if (point.squared_distance < all.best.squared_distance) {
      all.ties = 1;
      all.best = {point_at(point.weights, triangle.corners), TriangleId(i), triangle.as_given(point.weights),
                  point.squared_distance};
    }
  }
  return all;
}

inline bool same(const SurfacePoint& a, const SurfacePoint& b) {
  return a.position == b.position && a.triangle == b.triangle && a.weights == b.weights &&
         a.squared_distance == b.squared_distance;
}

}  // namespace quarry::test
