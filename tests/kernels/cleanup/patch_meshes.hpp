// Quad meshes with many irregular vertices, for tests of patches: the three-way split of a Delaunay
// triangulation of a disk, of a square, or of an L; and quads between lines.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/triangulation.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry::test {

// The valence energy of a mesh with ideal faces.
inline int energy_of(const Mesh& mesh) {
  const auto ideal = mesh.find_tag<VertexId, std::uint8_t>(kIdealTag);
  int energy = 0;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    energy += valence_energy(faces, ideal[v]);
  }
  return energy;
}

// Splits each triangle of a triangulation into three quads; the boundary is fixed.
inline Mesh split_three_ways(Mesh triangles) {
  ConstraintTags tags = ConstraintTags::add_to(triangles);
  for (const VertexId v : triangles.vertices())
    if (triangles.alive(v) && triangles.on_boundary(v)) tags.support[v] = Support::fixed();
  SubdivideReport report;
  return subdivide(std::move(triangles), NodedLines(), report, Progress());
}

// Shaken points of a hexagonal lattice inside a circle, and points on it; the tag of ideal faces is set. The
// number of quads is about right.
inline Mesh disk_of_quads(std::size_t quads, std::uint64_t seed) {
  const double area = std::numbers::pi;
  const double spacing = std::sqrt(area / (static_cast<double>(quads) / 6) * 2 / std::numbers::sqrt3);
  std::vector<Vec2> points;
  const auto rim = static_cast<std::size_t>(std::lround(2 * std::numbers::pi / spacing));
  for (std::size_t i = 0; i < rim; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rim);
    points.push_back({std::cos(turn), std::sin(turn)});
  }
  DelaunayOptions lattice;
  lattice.spacing = spacing;
  lattice.jitter = 0.25;
  lattice.seed = seed;
  for (const Vec2 p : make_spaced_points(Box2{{-1, -1}, {1, 1}}, lattice))
    if (length(p) < 1 - 0.6 * spacing) points.push_back(p);
  Mesh mesh = split_three_ways(delaunay_triangulation(points));
  set_ideal_faces(mesh, PlaneModel());
  return mesh;
}

// Quads between lines, cut open along them.
inline SyntheticMesh cut_network(const SyntheticOptions& options) {
  SyntheticMesh given = make_synthetic(options);
  PairingReport paired;
  const Pairing pairing = pair_triangles(given.mesh, given.tags, {}, paired, {});
  SubdivideReport halved;
  given.mesh = subdivide(merge_pairs(std::move(given.mesh), pairing), given.lines, halved, {});
  given.tags = ConstraintTags::of(given.mesh);
  cut_open(given.mesh, given.tags);
  set_ideal_faces(given.mesh, PlaneModel());
  return given;
}

// The same between random lines with dead ends.
inline SyntheticMesh cut_network(std::uint64_t seed) {
  return cut_network({.columns = 24, .rows = 20, .seed = seed, .jitter = 0.2});
}

}  // namespace quarry::test
