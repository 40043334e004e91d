#include "kernels/cleanup/patch_remesh.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/sectors.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/quality/face.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

std::size_t count_irregular(const Mesh& mesh) {
  std::size_t count = 0;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v) || mesh.on_boundary(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    count += faces != 4 ? 1 : 0;
  }
  return count;
}

// Boundary sides by their ends, with the places of these.
std::vector<std::pair<std::pair<VertexId, VertexId>, Vec2>> boundary_of(const Mesh& mesh) {
  std::vector<std::pair<std::pair<VertexId, VertexId>, Vec2>> sides;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      if (!mesh.neighbour(s).valid())
        sides.push_back({{mesh.origin(s), mesh.target(s)}, mesh.point(mesh.origin(s))});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return sides;
}

PatchOptions options_of(std::size_t largest) {
  PatchOptions options;
  options.largest = largest;
  return options;
}

TEST(RemeshPatches, LowersTheEnergyAndKeepsChargeValidityAndTheBoundary) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = test::disk_of_quads(1500, seed);
    const int charge = test::charge_of(mesh);
    const auto boundary = boundary_of(mesh);
    PatchMemory memory;
    for (const std::size_t largest : patch_classes(256, false, 0)) {
      SCOPED_TRACE("class " + std::to_string(largest));
      const int before = test::energy_of(mesh);
      const PatchReport report = remesh_patches(mesh, PlaneModel(), options_of(largest), memory, Progress());
      EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
      EXPECT_EQ(test::charge_of(mesh), charge);
      EXPECT_EQ(boundary_of(mesh), boundary);
      const int after = test::energy_of(mesh);
      if (report.count_won() > 0) {
        EXPECT_LT(after, before);
      } else {
        EXPECT_EQ(after, before);
      }
    }
    EXPECT_LT(count_irregular(mesh), 30U);
  }
}

TEST(RemeshPatches, LeavesFourIrregularVerticesInASmallDisk) {
  Mesh mesh = test::disk_of_quads(800, 5);
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(16, true, mesh.count_alive_faces()))
    remesh_patches(mesh, PlaneModel(), options_of(largest), memory, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(count_irregular(mesh), 4U);
}

TEST(RemeshPatches, FindsNothingInAGrid) {
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  for (std::uint32_t row = 0; row < 9; ++row)
    for (std::uint32_t column = 0; column < 9; ++column) {
      x.push_back(column);
      y.push_back(row);
    }
  for (std::uint32_t row = 0; row < 8; ++row)
    for (std::uint32_t column = 0; column < 8; ++column) {
      const std::uint32_t a = 9 * row + column;
      faces.push_back({VertexId(a), VertexId(a + 1), VertexId(a + 10), VertexId(a + 9)});
    }
  Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
  ConstraintTags::add_to(mesh);
  set_ideal_faces(mesh, PlaneModel());
  PatchMemory memory;
  const PatchReport report = remesh_patches(mesh, PlaneModel(), options_of(512), memory, Progress());
  EXPECT_EQ(report.seeds, 0U);
  EXPECT_EQ(report.searches, 0U);
}

TEST(RemeshPatches, NeverMovesNorRemovesAPinnedVertex) {
  Mesh mesh = test::disk_of_quads(1000, 7);
  ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<std::pair<VertexId, Vec2>> pinned;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); i += 13) {
    const VertexId v(i);
    if (!mesh.alive(v) || mesh.on_boundary(v)) continue;
    tags.support[v] = Support::fixed();
    pinned.emplace_back(v, mesh.point(v));
  }
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(64, false, 0))
    remesh_patches(mesh, PlaneModel(), options_of(largest), memory, Progress());
  for (const auto& [v, place] : pinned) {
    EXPECT_TRUE(mesh.alive(v));
    EXPECT_EQ(mesh.point(v), place);
  }
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(RemeshPatches, KeepsTheSmallestScaledJacobianAboveTheFloor) {
  Mesh mesh = test::disk_of_quads(1500, 9);
  PatchOptions options = options_of(64);
  options.least_jacobian = 0.5;
  double before = 1;
  for (const double value : scaled_jacobians(mesh)) before = std::min(before, value);
  PatchMemory memory;
  remesh_patches(mesh, PlaneModel(), options, memory, Progress());
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f)) {
      EXPECT_GE(scaled_jacobian(mesh, f), std::min(0.5, before) - 1e-12);
    }
}

TEST(RemeshPatches, RefusesFillsWhoseMeanFallsByMoreThanMay) {
  const auto won = [](double most_mean_loss) {
    Mesh mesh = test::disk_of_quads(1500, 9);
    PatchOptions options = options_of(64);
    options.most_mean_loss = most_mean_loss;
    PatchMemory memory;
    return remesh_patches(mesh, PlaneModel(), options, memory, Progress()).count_won();
  };
  EXPECT_EQ(won(-1), 0U) << "none can be better by one";
  EXPECT_GT(won(1), 10U);
  EXPECT_LE(won(0), won(1));
}

TEST(RemeshPatches, KeepsToTheGivenGrowth) {
  Mesh mesh = test::disk_of_quads(1500, 11);
  const auto faces = static_cast<double>(mesh.count_alive_faces());
  PatchOptions options;
  options.most_growth = options.most_shrinkage = 0.02;
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(128, false, 0)) {
    options.largest = largest;
    options.wanted_faces = static_cast<std::size_t>(faces);
    remesh_patches(mesh, PlaneModel(), options, memory, Progress());
    const auto now = static_cast<double>(mesh.count_alive_faces());
    EXPECT_LE(now, 1.02 * faces);
    EXPECT_GE(now, 0.98 * faces);
  }
}

TEST(RemeshPatches, KeepsTriangles) {
  Mesh mesh = test::disk_of_quads(1000, 13);
  // Quads in the middle are cut in two.
  ConstraintTags tags = ConstraintTags::of(mesh);
  std::size_t cut = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots() && cut < 10; i += 97, ++cut) {
    const FaceId f(i);
    const std::array<SideId, 4> across = {mesh.neighbour(SideId(f, 0)), mesh.neighbour(SideId(f, 1)),
                                          mesh.neighbour(SideId(f, 2)), mesh.neighbour(SideId(f, 3))};
    const std::array<VertexId, 4> c = {mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2),
                                       mesh.corner(f, 3)};
    const FaceId g = mesh.grow_faces(1);
    MeshEditor editor(mesh);
    editor.set_triangle(f, c[0], c[1], c[2]);
    editor.set_triangle(g, c[2], c[3], c[0]);
    editor.join(SideId(f, 2), SideId(g, 2));
    editor.join(SideId(f, 0), across[0]);
    editor.join(SideId(f, 1), across[1]);
    editor.join(SideId(g, 0), across[2]);
    editor.join(SideId(g, 1), across[3]);
    tags.sides[g] = 0;
  }
  rebuild_sides_of_vertices(mesh);
  ASSERT_EQ(validate(mesh, GeometryCheck::kNone), "");
  const int charge = test::charge_of(mesh);
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(64, false, 0))
    remesh_patches(mesh, PlaneModel(), options_of(largest), memory, Progress());
  std::size_t triangles = 0;
  for (const FaceId f : mesh.faces()) triangles += mesh.alive(f) && mesh.corner_count(f) == 3 ? 1 : 0;
  EXPECT_EQ(triangles, 2 * cut);
  EXPECT_EQ(test::charge_of(mesh), charge);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

// Irregular vertices left of the middle, over some disks.
std::size_t count_left(const IrregularPrice& price) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Mesh mesh = test::disk_of_quads(1500, seed);
    PatchOptions options;
    options.price = price;
    // Where most are still there: of the few that larger patches leave, chance decides.
    options.largest = 16;
    PatchMemory memory;
    remesh_patches(mesh, PlaneModel(), options, memory, Progress());
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    for (const VertexId v : mesh.vertices()) {
      if (!mesh.alive(v) || mesh.on_boundary(v) || mesh.point(v).x >= 0) continue;
      int faces = 0;
      for_each_side_around(mesh, v, [&](SideId) { ++faces; });
      count += faces != 4 ? 1 : 0;
    }
  }
  return count;
}

TEST(RemeshPatches, LeavesFewerIrregularVerticesWhereTheyAreDear) {
  // Dear on the left, and dear on the right: what lies on the left then differs by more than chance.
  const std::size_t dear = count_left([](Vec3 p) { return p.x < 0 ? 20.0 : 1.0; });
  const std::size_t cheap = count_left([](Vec3 p) { return p.x < 0 ? 1.0 : 20.0; });
  EXPECT_LT(static_cast<double>(dear), 0.9 * static_cast<double>(cheap)) << dear << " and " << cheap;
}

std::vector<std::uint64_t> remeshed(bool reverse) {
  Mesh mesh = test::disk_of_quads(1200, 17);
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(128, false, 0)) {
    PatchOptions options = options_of(largest);
    options.reverse = reverse;
    remesh_patches(mesh, PlaneModel(), options, memory, Progress());
  }
  return test::arrays_of(mesh);
}

TEST(RemeshPatches, IsTheSameOnAnyNumberOfThreadsAndInAnyOrderOfWinners) {
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] { serial = remeshed(false); });
  EXPECT_EQ(remeshed(true), serial);
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    std::vector<std::uint64_t> result;
    parallel::with_threads(threads, [&] { result = remeshed(false); });
    EXPECT_EQ(result, serial) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST(RemeshPatches, KeepsLinesWithDeadEnds) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SyntheticMesh given = test::cut_network(seed);
    Mesh& mesh = given.mesh;
    const int charge = test::charge_of(mesh);
    const auto boundary = boundary_of(mesh);
    int energy = test::energy_of(mesh);
    PatchMemory memory;
    for (const std::size_t largest : patch_classes(256, false, 0)) {
      const PatchReport report = remesh_patches(mesh, PlaneModel(), options_of(largest), memory, Progress());
      const int now = test::energy_of(mesh);
      EXPECT_TRUE(report.count_won() > 0 ? now < energy : now == energy);
      energy = now;
    }
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(test::charge_of(mesh), charge);
    EXPECT_EQ(boundary_of(mesh), boundary);
    sew(mesh, given.tags);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  }
}

#ifdef QUARRY_CHECK_CLAIMS
TEST(RemeshPatches, StaysInsideItsClaims) {
  reset_claim_violations();
  remeshed(false);
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}
#endif

}  // namespace
}  // namespace quarry
