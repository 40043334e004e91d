// A mesh of a wavy surface, which benchmarks work on where a network would not do.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"

namespace quarry::bench {

enum class WavyFaces : std::uint8_t { kTriangles, kQuads };

// side by side squares of edge 1, or rows of twice as many triangles, equilateral before they are bent.
[[nodiscard]] inline Mesh wavy_mesh(std::uint32_t side, WavyFaces kind) {
  const bool quads = kind == WavyFaces::kQuads;
  std::vector<double> x, y, z;
  std::vector<FaceCorners> faces;
  for (std::uint32_t j = 0; j <= side; ++j)
    for (std::uint32_t i = 0; i <= side; ++i) {
      x.push_back(i + (quads ? 0 : 0.5 * (j % 2)));
      y.push_back((quads ? 1 : 0.5 * std::sqrt(3.0)) * j);
      z.push_back(8 * std::sin(x.back() / 20) * std::cos(y.back() / 25));
    }
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const VertexId a(j * (side + 1) + i), b(a.value() + 1), c(a.value() + side + 1), d(c.value() + 1);
      if (quads) {
        faces.push_back({a, b, d, c});
        continue;
      }
      const bool even = j % 2 == 0;
      faces.push_back({a, b, even ? c : d, VertexId()});
      faces.push_back({even ? b : a, d, c, VertexId()});
    }
  return build_mesh(std::move(x), std::move(y), std::move(z), faces);
}

}  // namespace quarry::bench
