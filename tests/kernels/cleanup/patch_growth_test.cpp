#include "kernels/cleanup/patch_growth.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/patch_partners.hpp"
#include "kernels/cleanup/patch_sides.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"

namespace quarry {
namespace {

// All counters of a patch, from its faces alone.
void expect_counters_of(const PatchGrowth& growth, const Mesh& mesh, const PatchStars& stars) {
  std::map<VertexId, int> inside, rim_ends;
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const FaceId f : growth.faces()) {
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      const SideId across = mesh.neighbour(s);
      ++inside[mesh.origin(s)];
      edges.insert(std::minmax(mesh.origin(s), mesh.target(s)));
      if (across.valid() && growth.contains(across.face())) continue;
      ++rim_ends[mesh.origin(s)];
      ++rim_ends[mesh.target(s)];
    }
  }
  int charge = 0, reflex = 0;
  double energy = 0;
  EXPECT_EQ(growth.vertices().size(), inside.size());
  for (const auto& [v, faces] : inside) {
    EXPECT_EQ(growth.inside(v), faces);
    EXPECT_EQ(growth.on_rim(v), rim_ends.contains(v));
    charge += stars.ideal(v) - stars.faces(v);
    energy += valence_energy(stars.faces(v), stars.ideal(v));
    if (growth.on_rim(v) && growth.outside(v) == 0) reflex += std::max(0, stars.ideal(v) - 2);
  }
  EXPECT_EQ(growth.reflex(), reflex);
  EXPECT_EQ(growth.charge(), charge);
  EXPECT_EQ(growth.energy(), energy);
  const auto euler = static_cast<int>(inside.size()) - static_cast<int>(edges.size()) +
                     static_cast<int>(growth.faces().size());
  EXPECT_EQ(growth.is_disk(), euler == 1);
}

// Returns the most faces beyond two that tips and reflex corners of a patch asked for.
int grow_anywhere_in(const Mesh& mesh, std::uint64_t seed) {
  const PatchStars stars(mesh, {});
  PatchGrowth growth;
  int most = 0;
  for (std::uint64_t round = 0; round < 20; ++round) {
    growth.begin(mesh, stars, 400);
    for (std::uint64_t step = 0; step < 6; ++step) {
      const auto v = static_cast<std::uint32_t>(uniform01(seed, 100 * round + step) *
                                                static_cast<double>(mesh.vertex_slots()));
      if (!growth.add_star(VertexId(v))) break;
      expect_counters_of(growth, mesh, stars);
      most = std::max(most, growth.reflex());
    }
  }
  return most;
}

TEST(PatchGrowth, KeepsTheCountersThatARecountFinds) {
  int reflex = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    grow_anywhere_in(test::disk_of_quads(600, seed), seed);
    reflex = std::max(reflex, grow_anywhere_in(test::cut_network(seed).mesh, seed));
  }
  EXPECT_GE(reflex, 2) << "no patch has taken in all faces of a tip";
}

TEST(PatchGrowth, EndsConvexWithARimThatIsOneLoop) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = test::disk_of_quads(600, seed);
    const PatchStars stars(mesh, {});
    PatchGrowth growth;
    PatchPartners partners;
    std::vector<VertexId> path, rim;
    int disks = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); v += 3) {
      if (!stars.irregular(VertexId(v))) continue;
      partners.begin(mesh, stars, VertexId(v), 100);
      partners.path_from(partners.next(), path);
      EXPECT_EQ(path.back(), VertexId(v));
      growth.begin(mesh, stars, 100);
      if (!std::all_of(path.begin(), path.end(), [&](VertexId u) { return growth.add_star(u); })) continue;
      if (!growth.make_convex()) continue;
      expect_counters_of(growth, mesh, stars);
      for (const VertexId u : growth.rim_vertices())
        EXPECT_TRUE(growth.outer_angle(u) >= 0 || growth.outside(u) == 0);
      if (!growth.is_disk()) continue;
      ++disks;
      growth.walk_rim(rim);
      EXPECT_EQ(rim.size(), growth.rim_vertices().size());
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const SideId s = mesh.find_side(rim[i], rim[(i + 1) % rim.size()]);
        EXPECT_TRUE(s.valid() && growth.contains(s.face()));
      }
      // With no vertex that turns by more than a corner the charge tells the number of sides.
      const bool plain = std::all_of(rim.begin(), rim.end(), [&](VertexId u) {
        return growth.outer_angle(u) == 0 || growth.outer_angle(u) == 1;
      });
      if (plain) {
        EXPECT_EQ(static_cast<int>(find_sides(growth, rim, CornerRule::kOuterAngle).count),
                  4 - growth.charge());
      }
    }
    EXPECT_GT(disks, 10);
  }
}

TEST(PatchGrowth, RefusesToGrowBeyondItsLargestSizeAndOverPinnedVertices) {
  Mesh mesh = test::disk_of_quads(600, 1);
  VertexId inside;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && !mesh.on_boundary(v)) inside = v;
  PatchGrowth growth;
  const PatchStars stars(mesh, {});
  growth.begin(mesh, stars, 2);
  EXPECT_FALSE(growth.add_star(inside));
  ConstraintTags::of(mesh).support[inside] = Support::fixed();
  const PatchStars pinned(mesh, {});
  growth.begin(mesh, pinned, 100);
  EXPECT_FALSE(growth.add_star(inside));
}

TEST(PatchPartners, ComeInTheOrderOfTheirDistance) {
  const Mesh mesh = test::disk_of_quads(600, 3);
  const PatchStars stars(mesh, {});
  PatchPartners partners;
  std::vector<VertexId> path;
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); v += 7) {
    partners.begin(mesh, stars, VertexId(v), mesh.vertex_slots());
    std::size_t before = 0;
    std::set<VertexId> met;
    for (VertexId partner = partners.next(); partner.valid(); partner = partners.next()) {
      EXPECT_TRUE(met.insert(partner).second);
      EXPECT_TRUE(stars.irregular(partner));
      partners.path_from(partner, path);
      EXPECT_GE(path.size(), before);
      before = path.size();
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        EXPECT_TRUE(mesh.find_side(path[i], path[i + 1]).valid() ||
                    mesh.find_side(path[i + 1], path[i]).valid());
    }
    EXPECT_GT(met.size(), 50U);
  }
}

}  // namespace
}  // namespace quarry
