// Small triangulated surfaces that stand for what scans, CAD and structural models hold.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "surface/repair/triangle_surface.hpp"

namespace quarry::test {

inline TriangleSurface surface_of(std::vector<Vec3> points, std::vector<SurfaceTriangle> triangles) {
  std::vector<std::int32_t> groups(triangles.size(), 0);
  return {std::move(points), std::move(triangles), std::move(groups)};
}

// Twelve triangles, seen from outside.
inline TriangleSurface cube(double edge = 1, Vec3 low = {}) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(low + edge * Vec3{static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1),
                                       static_cast<double>(i >> 2)});
  return surface_of(points, {{0, 2, 3},
                             {0, 3, 1},
                             {4, 5, 7},
                             {4, 7, 6},
                             {0, 1, 5},
                             {0, 5, 4},
                             {2, 6, 7},
                             {2, 7, 3},
                             {0, 4, 6},
                             {0, 6, 2},
                             {1, 3, 7},
                             {1, 7, 5}});
}

// Each round cuts every triangle in four and puts the new points on the unit sphere; seen from outside.
inline TriangleSurface sphere(int rounds) {
  TriangleSurface s =
      surface_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                 {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.points.size()));
      if (fresh) {
        const Vec3 p = s.points[a] + s.points[b];
        s.points.push_back((1 / length(p)) * p);
      }
      return at->second;
    };
    std::vector<SurfaceTriangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s = surface_of(std::move(s.points), std::move(finer));
  }
  return s;
}

// A square of side 1 in z = height(x, y), cut into columns x rows cells of two triangles; its rim is open.
template <class Height>
TriangleSurface terrain(std::uint32_t columns, std::uint32_t rows, const Height& height) {
  TriangleSurface s;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double x = static_cast<double>(i) / columns;
      const double y = static_cast<double>(j) / rows;
      s.points.push_back({x, y, height(x, y)});
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i;
      const std::uint32_t b = a + columns + 1;
      s.triangles.push_back({a, a + 1, b + 1});
      s.triangles.push_back({a, b + 1, b});
    }
  s.groups.assign(s.triangles.size(), 0);
  return s;
}

// A terrain of 120 x 120 cells with a smooth narrow hill at each of the places (their z: its height); width:
// where it has fallen to 0.6 of that.
inline TriangleSurface narrow_hills(std::span<const Vec3> tops, double width) {
  return terrain(120, 120, [&](double x, double y) {
    double z = 0;
    for (const Vec3 top : tops) {
      const double dx = x - top.x, dy = y - top.y;
      z += top.z * std::exp(-(dx * dx + dy * dy) / (2 * width * width));
    }
    return z;
  });
}

// A band of one side: `cells` pairs of triangles around, with half a turn.
inline TriangleSurface moebius(std::uint32_t cells) {
  TriangleSurface s;
  for (std::uint32_t i = 0; i < cells; ++i) {
    const double angle = 2 * std::numbers::pi * i / cells;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(angle / 2);
      s.points.push_back({r * std::cos(angle), r * std::sin(angle), w * std::sin(angle / 2)});
    }
  }
  for (std::uint32_t i = 0; i < cells; ++i) {
    const bool last = i + 1 == cells;
    const std::uint32_t a = 2 * i, b = 2 * i + 1;
    const std::uint32_t c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    s.triangles.push_back({a, c, d});
    s.triangles.push_back({a, d, b});
  }
  s.groups.assign(s.triangles.size(), 0);
  return s;
}

// A cone of radius 1 and that height, open below: its apex, point 0, and `rings` rings of `sectors` points.
inline TriangleSurface cone(std::uint32_t sectors, std::uint32_t rings, double height) {
  TriangleSurface s;
  s.points.push_back({0, 0, height});
  for (std::uint32_t ring = 1; ring <= rings; ++ring)
    for (std::uint32_t i = 0; i < sectors; ++i) {
      const double r = static_cast<double>(ring) / rings;
      const double angle = 2 * std::numbers::pi * i / sectors;
      s.points.push_back({r * std::cos(angle), r * std::sin(angle), (1 - r) * height});
    }
  for (std::uint32_t i = 0; i < sectors; ++i) {
    const std::uint32_t next = (i + 1) % sectors;
    s.triangles.push_back({0, 1 + i, 1 + next});
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
      const std::uint32_t a = 1 + (ring - 1) * sectors + i, b = 1 + (ring - 1) * sectors + next;
      s.triangles.push_back({a, a + sectors, b + sectors});
      s.triangles.push_back({a, b + sectors, b});
    }
  }
  s.groups.assign(s.triangles.size(), 0);
  return s;
}

// Three squares that share the edge from (0, 0, 0) to (0, 0, 1), each of its own group.
inline TriangleSurface three_sheets() {
  TriangleSurface s;
  s.points = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3;
    const auto base = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back({std::cos(angle), std::sin(angle), 0});
    s.points.push_back({std::cos(angle), std::sin(angle), 1});
    s.triangles.push_back({0, base, base + 1});
    s.triangles.push_back({0, base + 1, 1});
    s.groups.insert(s.groups.end(), 2, i);
  }
  return s;
}

}  // namespace quarry::test
