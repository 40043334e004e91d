// A finished mesh as the pipeline hands it over, planar or with hills: quads and some triangles, two regions,
// constraint edges (some of two input lines), the outer boundary.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct SampleMesh {
  std::uint32_t size = 10;  // faces along each side of the square
  double disorder = 0.6;    // how far inner vertices move, in edges
  bool triangles = true;    // cut every seventh quad in two
  Vec2 corner{0, 0};
  std::uint64_t seed = 1;
  double relief = 0;  // how high its hills are, in its sides; 0: planar
};

inline double sample_height(const SampleMesh& sample, double x, double y) {
  const double n = sample.size;
  return sample.relief * n * std::sin(6 * (x - sample.corner.x) / n) *
         std::cos(5 * (y - sample.corner.y) / n);
}

inline std::uint32_t sample_vertex(const SampleMesh& sample, std::uint32_t i, std::uint32_t j) {
  return j * (sample.size + 1) + i;
}

// Edges of the constraint lines and of the outer boundary, with their tags.
inline void add_sample_edges(const SampleMesh& sample, Mesh& mesh) {
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  auto kind = mesh.add_tag<EdgeId, std::int32_t>("kind", 1);
  const std::uint32_t n = sample.size;
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t di, std::uint32_t dj, int line,
                       int what) {
    const EdgeId e =
        mesh.add_edge(VertexId(sample_vertex(sample, i, j)), VertexId(sample_vertex(sample, i + di, j + dj)));
    constraint[e] = line;
    kind[e] = what;
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    add(n / 2, j, 0, 1, 3, 1);
    if (j < n / 3) add(n / 2, j, 0, 1, 5, 1);
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    add(k, 0, 1, 0, 0, 2);
    add(k, n, 1, 0, 0, 2);
    add(0, k, 0, 1, -1, 2);
    add(n, k, 0, 1, -1, 2);
  }
}

inline Mesh make_sample_mesh(const SampleMesh& sample) {
  const std::uint32_t n = sample.size;
  std::vector<double> x, y;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      const double amount = inner ? sample.disorder : 0.0;
      const std::uint64_t k = sample_vertex(sample, i, j);
      x.push_back(sample.corner.x + i + amount * (uniform01(sample.seed, 2 * k) - 0.5));
      y.push_back(sample.corner.y + j + amount * (uniform01(sample.seed, 2 * k + 1) - 0.5));
    }
  std::vector<FaceCorners> faces;
  std::vector<std::int32_t> regions;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return VertexId(sample_vertex(sample, i, j)); };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      if (sample.triangles && (i + 3 * j) % 7 == 0) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), VertexId()});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1), VertexId()});
      } else {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
      while (regions.size() < faces.size()) regions.push_back(i < n / 2 ? 0 : 1);
    }
  std::vector<double> z;
  for (std::size_t v = 0; v < x.size(); ++v) z.push_back(sample_height(sample, x[v], y[v]));
  Mesh mesh = sample.relief == 0 ? build_mesh(std::move(x), std::move(y), faces)
                                 : build_mesh(std::move(x), std::move(y), std::move(z), faces);
  mesh.add_tag<FaceId, std::int32_t>("region").values().raw() = std::move(regions);
  add_sample_edges(sample, mesh);
  return mesh;
}

}  // namespace quarry
