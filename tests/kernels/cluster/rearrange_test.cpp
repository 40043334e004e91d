#include "kernels/cluster/rearrange.hpp"

#include <array>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/dissection.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/patch.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

struct Mixed {
  Mesh mesh;
  NodedLines lines;
};

Mixed make_mixed(const test::SyntheticOptions& options) {
  test::SyntheticMesh made = test::make_synthetic(options);
  PairingReport report;
  const Pairing pairing = pair_triangles(made.mesh, made.tags, {}, report, Progress());
  return {merge_pairs(std::move(made.mesh), pairing), std::move(made.lines)};
}

std::size_t count_triangles(const Mesh& mesh) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces()) count += mesh.alive(f) && mesh.corner_count(f) == 3 ? 1 : 0;
  return count;
}

double constrained_length(const Mesh& mesh) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  double length = 0;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      if (tags.constrained(s)) length += distance(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
    }
  }
  return length;
}

std::vector<std::uint32_t> corners_of(const Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 4; ++k) corners.push_back(mesh.corner(f, k).value());
  return corners;
}

TEST(Dissections, AreAsManyAsTheCountsSayAndFillThePolygon) {
  const std::array<std::size_t, kMostPolygonCorners + 1> expected = {0, 0, 0, 0, 3, 5, 3, 28, 12, 165, 55};
  for (int corners = 4; corners <= kMostPolygonCorners; ++corners) {
    EXPECT_EQ(dissections(corners).size(), expected[static_cast<std::size_t>(corners)]);
    for (const Dissection& cut : dissections(corners)) {
      // Triangles that the faces would take.
      EXPECT_EQ(2 * cut.face_count - cut.triangle_count, corners - 2);
      int meetings = 0;
      for (const std::uint8_t faces : cut.faces_at) meetings += faces;
      EXPECT_EQ(meetings, 4 * cut.face_count - cut.triangle_count);
    }
  }
}

TEST(Patch, CutAndCutAgainIsAValidMeshForEveryDissection) {
  for (std::size_t which = 0; which < 3; ++which) {
    Mixed mixed = make_mixed(
        {.columns = 6, .rows = 6, .jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
    const ConstraintTags tags = ConstraintTags::of(mixed.mesh);
    const std::array<FaceId, 2> faces = {FaceId(14U), mixed.mesh.neighbour(SideId(FaceId(14U), 0)).face()};
    Patch patch;
    ASSERT_TRUE(patch.gather(mixed.mesh, tags, faces));
    ASSERT_EQ(patch.corners(), 6);
    MeshEditor editor(mixed.mesh);
    patch.apply(editor, tags, dissections(6)[which], {});
    EXPECT_EQ(validate(mixed.mesh, GeometryCheck::kNone), "");
  }
}

class RearrangementOf : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RearrangementOf, ASyntheticMeshLeavesFewerTrianglesAndEveryConstraint) {
  Mixed mixed = make_mixed({.seed = GetParam()});
  const std::size_t before = count_triangles(mixed.mesh);
  const double length = constrained_length(mixed.mesh);
  const PassReport report = rearrange(mixed.mesh, {}, Progress());
  EXPECT_GT(report.won, 0U);
  EXPECT_EQ(validate(mixed.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_LT(count_triangles(mixed.mesh), before);
  EXPECT_NEAR(constrained_length(mixed.mesh), length, 1e-6 * length);
  SubdivideReport divided;
  const Mesh quads = subdivide(std::move(mixed.mesh), mixed.lines, divided, Progress());
  EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
}

INSTANTIATE_TEST_SUITE_P(Seeds, RearrangementOf, testing::Range<std::uint64_t>(1, 25));

TEST(Rearrange, GivesTheSameMeshOnAnyNumberOfThreads) {
  std::vector<std::uint32_t> expected;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      Mixed mixed = make_mixed({.columns = 60, .rows = 40, .seed = 7});
      const parallel::ParticipationProbe probe;
      rearrange(mixed.mesh, {}, Progress());
      if (threads == 1) {
        expected = corners_of(mixed.mesh);
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(corners_of(mixed.mesh), expected);
    });
  }
}

TEST(Rearrange, LeavesARegularMeshAlone) {
  Mixed mixed = make_mixed({.jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
  EXPECT_EQ(rearrange(mixed.mesh, {}, Progress()).won, 0U);
}

TEST(Rearrange, StaysWithinItsClaims) {
  reset_claim_violations();
  Mixed mixed = make_mixed({.columns = 40, .rows = 40, .seed = 11});
  rearrange(mixed.mesh, {}, Progress());
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

}  // namespace
}  // namespace quarry
