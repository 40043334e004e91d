#include "kernels/cleanup/local.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/balance.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "tests/kernels/cleanup/local_meshes.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

LocalCleanupReport clean_up(Mesh& mesh, bool reverse = false) {
  return clean_up_locally(mesh, PlaneModel(), {.reverse = reverse}, Progress());
}

void expect_clean(Mesh mesh) {
  const ModelBalance balance = balance_of(mesh, PlaneModel());
  const auto boundary = test::boundary_of(mesh);
  reset_claim_violations();
  const LocalCleanupReport report = clean_up(mesh);
  EXPECT_EQ(find_imbalance(mesh, PlaneModel(), balance), "");
  EXPECT_EQ(test::boundary_of(mesh), boundary);
  EXPECT_LT(report.energy_after, report.energy_before);
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

std::vector<std::pair<VertexId, VertexId>> constrained_edges(const Mesh& mesh) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k)
      if (const SideId s(f, k); tags.constrained(s)) edges.emplace_back(mesh.origin(s), mesh.target(s));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

class LocalCleanup : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LocalCleanup, KeepsTheBalanceAndTheBoundaryOfHalvedMeshes) {
  expect_clean(test::open_halved_mesh({.seed = GetParam()}));
}

TEST_P(LocalCleanup, KeepsTheBalanceAndTheBoundaryOfMixedMeshesWithInvalidFaces) {
  expect_clean(test::open_paired_mesh({.seed = GetParam()}));
}

TEST_P(LocalCleanup, LeavesThreeToFiveFacesInsideASplitDisk) {
  Mesh mesh = test::open_split_disk(2000, GetParam());
  const LocalCleanupReport report = clean_up(mesh);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v) || mesh.on_boundary(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    EXPECT_GE(faces, 3);
    EXPECT_LE(faces, 5);
  }
  EXPECT_LT(report.irregular_after, report.irregular_before / 2);
}

TEST_P(LocalCleanup, SewnUpAgainKeepsEveryConstraint) {
  Mesh untouched = test::open_halved_mesh({.seed = GetParam()});
  Mesh mesh = test::open_halved_mesh({.seed = GetParam()});
  clean_up(mesh);
  sew(mesh, ConstraintTags::of(mesh));
  sew(untouched, ConstraintTags::of(untouched));
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(constrained_edges(mesh), constrained_edges(untouched));
}

INSTANTIATE_TEST_SUITE_P(Seeds, LocalCleanup, testing::Range<std::uint64_t>(1, 11));

TEST(LocalCleanupOfOneMesh, GivesTheSameBytesOnAnyNumberOfThreadsAndInReverse) {
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7, -1}) {
    parallel::with_threads(std::max(threads, 1), [&] {
      Mesh mesh = test::open_paired_mesh({.columns = 40, .rows = 40, .seed = 7});
      const parallel::ParticipationProbe probe;
      const LocalCleanupReport report = clean_up(mesh, threads < 0);
      EXPECT_GT(report.energy_before, report.energy_after);
      EXPECT_TRUE(threads <= 1 || probe.chunks_of_other_threads() > 0);
      if (expected.empty()) expected = test::arrays_of(mesh);
      EXPECT_EQ(test::arrays_of(mesh), expected) << threads;
    });
  }
}

// Irregular vertices left of the middle of some disks, dear on one side.
std::size_t count_left(double price_left, double price_right) {
  constexpr Vec2 kMiddle{6700000.0, 500000.0};
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Mesh mesh = test::open_split_disk(2000, seed);
    const IrregularPrice price = [&](Vec3 p) { return p.x < kMiddle.x ? price_left : price_right; };
    reset_claim_violations();
    (void)clean_up_locally(mesh, PlaneModel(), {.price = price}, Progress());
    EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    for (const VertexId v : mesh.vertices()) {
      if (!mesh.alive(v) || mesh.on_boundary(v) || mesh.point(v).x >= kMiddle.x) continue;
      int faces = 0;
      for_each_side_around(mesh, v, [&](SideId) { ++faces; });
      count += faces != 4 ? 1 : 0;
    }
  }
  return count;
}

TEST(LocalCleanupOfOneMesh, KeepsToWhatIsCheap) {
  // Only what crosses the middle can profit; one price everywhere is as good as none.
  EXPECT_EQ(count_left(20, 20), count_left(1, 1));
  EXPECT_LT(count_left(20, 1), count_left(1, 20));
}

TEST(LocalCleanupOfOneMesh, CountsEveryAttempt) {
  Mesh mesh = test::open_paired_mesh({.seed = 3});
  const LocalCleanupReport report = clean_up(mesh);
  ASSERT_EQ(report.operators.size(), 6U);
  for (const LocalOperatorReport& one : report.operators) {
    EXPECT_EQ(one.pass.won, one.won + one.invalid + one.poor) << one.pass.name;
    EXPECT_GE(one.pass.live, one.pass.won) << one.pass.name;
    EXPECT_GE(one.pass.proposed, one.pass.live) << one.pass.name;
    EXPECT_EQ(one.pass.rounds > 0, one.pass.proposed > 0) << one.pass.name;
  }
  EXPECT_GT(report.operators[0].won, 0U);
}

}  // namespace
}  // namespace quarry
