// What lines have of a mesh that operations over lines change: that each is covered, and the valence energy
// by the sectors between them.
#pragma once

#include <cstdint>
#include <map>

#include <gtest/gtest.h>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"

namespace quarry::test {

// The valence energy of the mesh cut open, sector by sector.
inline int energy_by_sectors(Mesh& mesh) {
  cut_open(mesh, ConstraintTags::of(mesh));
  set_ideal_faces(mesh, PlaneModel());
  const int energy = energy_of(mesh);
  sew(mesh, ConstraintTags::of(mesh));
  return energy;
}

// The length of the constrained edges on each piece; the edges must lie on it.
inline std::map<std::uint32_t, double> covered(const Mesh& mesh, const ConstraintTags& tags,
                                               const NodedLines& lines) {
  const PieceFinder pieces(lines);
  std::map<std::uint32_t, double> length_on;
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      const SideId across = mesh.neighbour(s);
      EXPECT_TRUE(!across.valid() || tags.constrained(s) == tags.constrained(across));
      if (!tags.constrained(s) || (across.valid() && across < s)) continue;
      const VertexId a = mesh.origin(s), b = mesh.target(s);
      const PieceId piece = pieces.under_edge(tags.support[a], tags.support[b]);
      length_on[piece.value()] += length(mesh.point(b) - mesh.point(a));
    }
  }
  return length_on;
}

inline void expect_covered(const std::map<std::uint32_t, double>& now,
                           const std::map<std::uint32_t, double>& before) {
  ASSERT_EQ(now.size(), before.size());
  for (const auto& [piece, all] : before) EXPECT_NEAR(now.at(piece), all, 1e-9 * all) << "piece " << piece;
}

}  // namespace quarry::test
