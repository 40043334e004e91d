// Meshes to find fields on, and which of their vertices have one given.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "kernels/crossfield/cross_field.hpp"
#include "kernels/crossfield/field_levels.hpp"
#include "surface/repair/repair.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry::test {

inline Mesh sphere_mesh(int rounds) { return make_sheets(repair_surface(sphere(rounds), {})); }

// Of radius 1 in the plane: a centre and rings of 6, 12, 18 ... vertices.
inline Mesh disk_mesh(std::uint32_t rings) {
  std::vector<Vec2> points{{0, 0}};
  std::vector<std::uint32_t> first{0};
  for (std::uint32_t r = 1; r <= rings; ++r) {
    first.push_back(static_cast<std::uint32_t>(points.size()));
    for (std::uint32_t k = 0; k < 6 * r; ++k) {
      const double angle = 2 * std::numbers::pi * k / (6 * r);
      points.push_back({std::cos(angle) * r / rings, std::sin(angle) * r / rings});
    }
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t r = 1; r <= rings; ++r) {
    const auto outer = [&](std::uint32_t k) { return first[r] + k % (6 * r); };
    const auto inner = [&](std::uint32_t k) { return r == 1 ? 0 : first[r - 1] + k % (6 * (r - 1)); };
    for (std::uint32_t sextant = 0; sextant < 6; ++sextant)
      for (std::uint32_t k = 0; k < r; ++k) {
        const std::uint32_t o = sextant * r + k, i = sextant * (r - 1) + k;
        faces.push_back({outer(o), outer(o + 1), inner(i)});
        if (k + 1 < r) faces.push_back({inner(i), outer(o + 1), inner(i + 1)});
      }
  }
  return mesh_of(points, faces);
}

// 1 at the vertices of the rim.
inline std::vector<std::uint8_t> rim_of(const Mesh& mesh) {
  std::vector<std::uint8_t> given(mesh.vertex_slots());
  for (const VertexId v : mesh.vertices()) given[v.value()] = mesh.on_boundary(v) ? 1 : 0;
  return given;
}

}  // namespace quarry::test
