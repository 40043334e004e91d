// What the ways in which a patch is looked for are good for, one by one.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/cleanup/patch_partners.hpp"
#include "kernels/cleanup/patch_remesh.hpp"
#include "kernels/cleanup/patch_sides.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"
#include "tests/support/charge.hpp"

namespace quarry {
namespace {

constexpr std::uint64_t kSeeds = 5;

// Calls look(growth, rim) for convex patches that are disks, grown from irregular vertices.
template <class Look>
void for_each_patch(const Mesh& mesh, std::size_t largest, const Look& look) {
  const PatchStars stars(mesh, {});
  PatchGrowth growth;
  PatchPartners partners;
  std::vector<VertexId> path, rim;
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.alive(VertexId(v)) || !stars.irregular(VertexId(v))) continue;
    partners.begin(mesh, stars, VertexId(v), largest);
    const VertexId partner = partners.next();
    if (!partner.valid()) continue;
    partners.path_from(partner, path);
    growth.begin(mesh, stars, largest);
    if (!std::all_of(path.begin(), path.end(), [&](VertexId u) { return growth.add_star(u); })) continue;
    if (!growth.make_convex() || !growth.is_disk()) continue;
    growth.walk_rim(rim);
    look(growth, rim);
  }
}

TEST(PatchSides, ByInnerFacesTurnAtVerticesOfOneFace) {
  std::size_t patches = 0, other_than_outer = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    for_each_patch(test::cut_network(seed).mesh, 100, [&](const PatchGrowth& growth, const auto& rim) {
      const PatchSides sides = find_sides(growth, rim, CornerRule::kInnerFaces);
      const auto ones =
          std::count_if(rim.begin(), rim.end(), [&](VertexId v) { return growth.inside(v) == 1; });
      ASSERT_EQ(sides.count, static_cast<std::uint32_t>(ones));
      if (sides.count == 0 || sides.count > kMostSides) return;
      ++patches;
      if (!(sides == find_sides(growth, rim, CornerRule::kOuterAngle))) ++other_than_outer;
      std::size_t edges = 0;
      for (std::uint32_t i = 0; i < sides.count; ++i) {
        EXPECT_EQ(growth.inside(rim[sides.corners[i]]), 1);
        edges += sides.lengths[i];
        for (std::uint32_t k = 1; k < sides.lengths[i]; ++k)
          EXPECT_NE(growth.inside(rim[(sides.corners[i] + k) % rim.size()]), 1);
      }
      EXPECT_EQ(edges, rim.size());
    });
  }
  EXPECT_GT(patches, 100U);
  EXPECT_GT(other_than_outer, 10U) << "the rules never differ: one of them is not needed";
}

bool joined_twice(const Mesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, int> sides;
  for (const FaceId f : mesh.faces())
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k)
      if (++sides[{mesh.origin(SideId(f, k)), mesh.target(SideId(f, k))}] > 1) return true;
  return false;
}

struct Outcome {
  int energy = 0;  // of all meshes together
  PatchReport report;
};

// All size classes up to the largest on disks and networks, whose charge, validity and edges are looked at.
Outcome remesh_all(PatchOptions options, std::size_t largest) {
  Outcome outcome;
  const auto remesh = [&](Mesh mesh) {
    const int charge = test::charge_of(mesh);
    PatchMemory memory;
    for (const std::size_t size : patch_classes(largest, false, 0)) {
      options.largest = size;
      outcome.report.add(remesh_patches(mesh, PlaneModel(), options, memory, Progress()));
    }
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(test::charge_of(mesh), charge);
    EXPECT_FALSE(joined_twice(mesh));
    outcome.energy += test::energy_of(mesh);
  };
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    remesh(test::disk_of_quads(1500, seed));
    remesh(test::cut_network(seed).mesh);
  }
  return outcome;
}

TEST(PatchChoice, FindsMoreWithMorePartnersAndDirections) {
  // Most of what is left when all is over is chance: small patches alone.
  const auto energy = [](int partners, int directions) {
    PatchOptions options;
    options.partners = partners;
    options.directions = directions;
    options.most_work = 1e9;  // single rows and sides also where there are many seeds
    return remesh_all(options, 32).energy;
  };
  const int one = energy(1, 0), four = energy(4, 0), sided = energy(1, 4), all = energy(4, 4);
  EXPECT_LT(four, one);
  EXPECT_LT(sided, one);
  EXPECT_LT(all, four);
}

TEST(PatchChoice, FillsPatchesOfEveryKindAndNeverJoinsVerticesTwice) {
  const PatchReport report = remesh_all({}, 128).report;
  for (const FillKind kind : {FillKind::kThree, FillKind::kGrid, FillKind::kPair, FillKind::kFive})
    EXPECT_GT(report.won[static_cast<std::size_t>(kind)], 0U) << static_cast<int>(kind);
}

}  // namespace
}  // namespace quarry
