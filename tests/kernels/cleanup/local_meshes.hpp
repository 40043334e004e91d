// Meshes with many irregular vertices, cut open along their constraints, for tests of local clean-up.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/balance.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "tests/support/split_disk.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry::test {

// Quads alone, all valid: pairs and single triangles of a synthetic mesh, halved.
inline Mesh open_halved_mesh(const SyntheticOptions& options) {
  SyntheticMesh made = make_synthetic(options);
  PairingReport pairing;
  Mesh mixed =
      merge_pairs(std::move(made.mesh), pair_triangles(made.mesh, made.tags, {}, pairing, Progress()));
  SubdivideReport report;
  Mesh mesh = subdivide(std::move(mixed), made.lines, report, Progress());
  cut_open(mesh, ConstraintTags::of(mesh));
  return mesh;
}

// Triangles of a synthetic mesh merged at random: doublets, flat quads at the outline, quads turned inside
// out, single triangles.
inline Mesh open_paired_mesh(const SyntheticOptions& options) {
  SyntheticMesh made = make_synthetic(options);
  Pairing pairing;
  pairing.merged.resize(made.mesh.face_slots());
  for (const FaceId f : made.mesh.faces()) {
    const SideId s(f,
                   static_cast<int>(mix32(f.value() ^ mix32(static_cast<std::uint32_t>(options.seed))) % 3));
    const SideId t = made.mesh.neighbour(s);
    if (!t.valid() || made.tags.constrained(s) || pairing.merged[f].valid() ||
        pairing.merged[t.face()].valid())
      continue;
    pairing.merged[f] = s;
    pairing.merged[t.face()] = t;
  }
  Mesh mesh = merge_pairs(std::move(made.mesh), pairing);
  cut_open(mesh, ConstraintTags::of(mesh));
  return mesh;
}

inline Mesh open_split_disk(double quads, std::uint64_t seed) {
  Mesh mesh = make_split_disk(quads, seed, {6700000.0, 500000.0});
  cut_open(mesh, ConstraintTags::of(mesh));
  return mesh;
}

// The boundary sides as pairs of points and vertices, with their constraint bits, sorted.
struct BoundarySide {
  VertexId from, to;
  double x, y;
  bool constrained;
  friend auto operator<=>(const BoundarySide&, const BoundarySide&) = default;
};
inline std::vector<BoundarySide> boundary_of(const Mesh& mesh) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<BoundarySide> sides;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      if (mesh.neighbour(s).valid()) continue;
      const Vec2 p = mesh.point(mesh.origin(s));
      sides.push_back({mesh.origin(s), mesh.target(s), p.x, p.y, tags.constrained(s)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace quarry::test
