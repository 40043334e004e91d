// Triangle meshes for the tests of matching: in the plane with and without constraints, and closed in space.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/initial/delaunay.hpp"

namespace quarry::test {

// Edges by their ends: directed on the boundary, from the smaller end on constraints.
using Ends = std::set<std::pair<VertexId, VertexId>>;

inline Ends boundary_of(const Mesh& mesh) {
  Ends ends;
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f))
      for (int k = 0; k < mesh.corner_count(f); ++k)
        if (const SideId s(f, k); !mesh.neighbour(s).valid()) ends.emplace(mesh.origin(s), mesh.target(s));
  return ends;
}

inline Ends constraints_of(const Mesh& mesh) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  Ends ends;
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f))
      for (int k = 0; k < mesh.corner_count(f); ++k)
        if (const SideId s(f, k); tags.constrained(s))
          ends.insert(std::minmax(mesh.origin(s), mesh.target(s)));
  return ends;
}

inline Mesh with_fixed_rim(Mesh mesh) {
  auto tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  return mesh;
}

// Without a boundary triangle whose third corner is inside, if the number is odd.
inline Mesh delaunay_mesh(double width, double height, std::uint64_t seed, double jitter = 0.25) {
  const Mesh mesh = make_delaunay({{0, 0}, {width, height}}, {.spacing = 1, .jitter = jitter, .seed = seed});
  FaceId left_out;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (!mesh.neighbour(SideId(f, k)).valid() && !mesh.on_boundary(mesh.corner(f, (k + 2) % 3)))
        left_out = f;
  std::vector<FaceCorners> faces;
  for (const FaceId f : mesh.faces())
    if (mesh.face_slots() % 2 == 0 || f != left_out)
      faces.push_back({mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), VertexId()});
  return with_fixed_rim(build_mesh(mesh.xs(), mesh.ys(), faces));
}

// The icosahedron, each triangle cut in four `levels` times, on the unit sphere.
inline Mesh icosphere(int levels) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  std::vector<Vec3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<std::uint32_t, 3>> faces = {
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (fresh) points.push_back(0.5 * (points[a] + points[b]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  std::vector<double> x, y, z;
  for (const Vec3 p : points) {
    const Vec3 q = (1 / length(p)) * p;
    x.push_back(q.x);
    y.push_back(q.y);
    z.push_back(q.z);
  }
  std::vector<FaceCorners> corners;
  for (const auto& [a, b, c] : faces) corners.push_back({VertexId(a), VertexId(b), VertexId(c), VertexId()});
  Mesh mesh = build_mesh(std::move(x), std::move(y), std::move(z), corners);
  (void)ConstraintTags::add_to(mesh);
  return mesh;
}

// A ring of cells between two circles, each cut in two.
inline Mesh triangle_annulus(std::uint32_t cells, std::uint32_t rings) {
  std::vector<double> x, y;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const double turn = 2 * 3.14159265358979 * i / cells;
      x.push_back((10.0 + ring) * std::cos(turn));
      y.push_back((10.0 + ring) * std::sin(turn));
    }
  }
  std::vector<FaceCorners> faces;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const VertexId a(ring * cells + i), b((ring + 1) * cells + i);
      const VertexId c((ring + 1) * cells + (i + 1) % cells), d(ring * cells + (i + 1) % cells);
      faces.push_back({a, b, c, VertexId()});
      faces.push_back({a, c, d, VertexId()});
    }
  }
  return with_fixed_rim(build_mesh(std::move(x), std::move(y), faces));
}

}  // namespace quarry::test
