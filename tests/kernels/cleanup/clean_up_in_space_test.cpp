// The operators and patches of clean-up on a surface in space.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/balance.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/local.hpp"
#include "kernels/cleanup/patch_remesh.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

// Of radius 1 about the origin.
class SphereModel final : public SpaceModel {
 public:
  [[nodiscard]] SpacePoint project(const SpacePoint& p) const override {
    const Vec3 up = (1 / length(p.place)) * p.place;
    return {up, up};
  }
};

const SpaceModel& sphere() {
  static const SphereModel model;
  return model;
}

// Three quads for each triangle of a sphere whose points are shaken: half of the vertices are irregular.
Mesh sphere_of_quads(int rounds, std::uint64_t seed) {
  TriangleSurface surface = test::sphere(rounds);
  const double shake = 0.25 * std::pow(0.5, rounds);
  std::uint64_t draw = 0;
  std::vector<double> x, y, z;
  std::vector<FaceCorners> faces;
  for (const Vec3 p : surface.points) {
    const auto by = [&] { return shake * (uniform01(seed, draw++) - 0.5); };
    const double dx = by(), dy = by(), dz = by();
    x.push_back(p.x + dx);
    y.push_back(p.y + dy);
    z.push_back(p.z + dz);
  }
  for (const auto& [a, b, c] : surface.triangles)
    faces.push_back({VertexId(a), VertexId(b), VertexId(c), VertexId()});
  Mesh triangles = build_mesh(std::move(x), std::move(y), std::move(z), faces);
  static_cast<void>(ConstraintTags::add_to(triangles));
  SubdivideReport report;
  Mesh mesh = subdivide_in_space(std::move(triangles), report);
  auto normals = mesh.add_normals();
  for (const VertexId v : mesh.vertices()) {
    const SpacePoint foot = sphere().project({mesh.point3(v), Vec3()});
    mesh.set_point3(v, foot.place);
    normals[v] = foot.up;
  }
  set_ideal_faces(mesh, sphere());
  return mesh;
}

void expect_on_sphere(const Mesh& mesh) {
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v)) {
      EXPECT_NEAR(length(mesh.point3(v)), 1, 1e-12);
    }
}

class CleanUpInSpace : public testing::TestWithParam<std::uint64_t> {};

TEST_P(CleanUpInSpace, ByLocalOperatorsKeepsTheBalanceAndTheSurface) {
  Mesh mesh = sphere_of_quads(4, GetParam());
  const ModelBalance balance = balance_of(mesh, sphere());
  const int charge = test::charge_of(mesh);
  reset_claim_violations();
  const LocalCleanupReport report = clean_up_locally(mesh, sphere(), {}, Progress());
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
  EXPECT_EQ(find_imbalance(mesh, sphere(), balance), "");
  EXPECT_EQ(test::charge_of(mesh), charge);
  EXPECT_LT(report.energy_after, report.energy_before / 2);
  for (const LocalOperatorReport& one : report.operators)
    EXPECT_EQ(one.pass.won, one.won + one.invalid + one.poor) << one.pass.name;
  expect_on_sphere(mesh);
}

TEST_P(CleanUpInSpace, ByPatchesKeepsTheBalanceAndTheSurface) {
  Mesh mesh = sphere_of_quads(4, GetParam());
  const int charge = test::charge_of(mesh);
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(128, false, 0)) {
    SCOPED_TRACE("class " + std::to_string(largest));
    const ModelBalance balance = balance_of(mesh, sphere());
    const int before = test::energy_of(mesh);
    PatchOptions options;
    options.largest = largest;
    EXPECT_GT(remesh_patches(mesh, sphere(), options, memory, Progress()).count_won(), 0U);
    EXPECT_EQ(find_imbalance(mesh, sphere(), balance), "");
    EXPECT_LT(test::energy_of(mesh), before);
  }
  EXPECT_EQ(test::charge_of(mesh), charge);
  expect_on_sphere(mesh);
}

TEST_P(CleanUpInSpace, LeavesPinnedVerticesWhereTheyAre) {
  Mesh mesh = sphere_of_quads(3, GetParam());
  ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<std::pair<VertexId, Vec3>> pinned;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); i += 17) {
    tags.support[VertexId(i)] = Support::fixed();
    pinned.emplace_back(VertexId(i), mesh.point3(VertexId(i)));
  }
  clean_up_locally(mesh, sphere(), {}, Progress());
  PatchMemory memory;
  for (const std::size_t largest : patch_classes(64, false, 0)) {
    PatchOptions options;
    options.largest = largest;
    remesh_patches(mesh, sphere(), options, memory, Progress());
  }
  for (const auto& [v, place] : pinned) {
    EXPECT_TRUE(mesh.alive(v));
    EXPECT_EQ(mesh.point3(v), place);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CleanUpInSpace, testing::Range<std::uint64_t>(1, 6));

TEST(CleanUpOfOneSphere, GivesTheSameBytesOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7})
    parallel::with_threads(threads, [&] {
      Mesh mesh = sphere_of_quads(4, 9);
      const parallel::ParticipationProbe probe;
      clean_up_locally(mesh, sphere(), {}, Progress());
      PatchMemory memory;
      PatchOptions options;
      options.largest = 64;
      remesh_patches(mesh, sphere(), options, memory, Progress());
      EXPECT_TRUE(threads == 1 || probe.chunks_of_other_threads() > 0);
      if (expected.empty()) expected = test::arrays_of(mesh);
      EXPECT_EQ(test::arrays_of(mesh), expected) << threads;
    });
}

}  // namespace
}  // namespace quarry
