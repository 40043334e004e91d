#include "kernels/cluster/subdivide.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/cut_quad.hpp"
#include "kernels/cluster/merge.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

Mesh quads_of(test::SyntheticMesh& made, SubdivideReport& report) {
  PairingReport paired;
  const Pairing pairing = pair_triangles(made.mesh, made.tags, {}, paired, Progress());
  return subdivide(merge_pairs(std::move(made.mesh), pairing), made.lines, report, Progress());
}

// sum over inner vertices of (4 - faces) + over rim vertices of (2 - faces) = 4 X - triangles.
int charge(const Mesh& mesh) {
  int sum = 0;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    sum += (mesh.on_boundary(v) ? 2 : 4) - faces;
  }
  return sum;
}

class EverySyntheticMesh : public testing::TestWithParam<std::uint64_t> {
 protected:
  EverySyntheticMesh()
      : made_(test::make_synthetic({.seed = GetParam(), .slivers = GetParam() % 3 == 0 ? 0.02 : 0})) {}
  test::SyntheticMesh made_;
};

TEST_P(EverySyntheticMesh, BecomesValidQuadsWithBalancedCharge) {
  SubdivideReport report;
  const Mesh quads = quads_of(made_, report);
  EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(report.quads, quads.count_alive_faces());
  for (const FaceId f : quads.faces()) ASSERT_EQ(quads.corner_count(f), 4);
  EXPECT_EQ(charge(quads), 4);
}

TEST_P(EverySyntheticMesh, KeepsEachConstraintAsAChainOfEdges) {
  double length_before = 0;
  for (const Piece& piece : made_.lines.pieces)
    length_before += distance(made_.lines.nodes[piece.from], made_.lines.nodes[piece.to]);
  SubdivideReport report;
  const Mesh quads = quads_of(made_, report);
  const ConstraintTags tags = ConstraintTags::of(quads);
  double length_after = 0;
  for (const FaceId f : quads.faces()) {
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      if (!tags.constrained(s)) continue;
      ASSERT_TRUE(tags.constrained(quads.neighbour(s)));
      EXPECT_FALSE(tags.support[quads.origin(s)].is_free());
      length_after += 0.5 * distance(quads.point(quads.origin(s)), quads.point(quads.target(s)));
    }
  }
  EXPECT_NEAR(length_after, length_before, 1e-7 * length_before);
}

TEST_P(EverySyntheticMesh, HasSlidingVerticesOnTheirPiecesWithinARounding) {
  SubdivideReport report;
  const Mesh quads = quads_of(made_, report);
  const ConstraintTags tags = ConstraintTags::of(quads);
  const double ulp = std::numeric_limits<double>::epsilon() * 6.8e6;
  for (const VertexId v : quads.vertices()) {
    if (!tags.support[v].slides()) continue;
    const Piece& piece = made_.lines.pieces[tags.support[v].piece()];
    EXPECT_LE(squared_distance(quads.point(v), made_.lines.nodes[piece.from], made_.lines.nodes[piece.to]),
              ulp * ulp);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, EverySyntheticMesh, testing::Range<std::uint64_t>(1, 25));

TEST(Subdivide, GivesTheSameMeshOnAnyNumberOfThreads) {
  std::vector<double> x;
  std::vector<std::uint32_t> corners;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      test::SyntheticMesh made = test::make_synthetic({.columns = 90, .rows = 40, .seed = 5});
      const parallel::ParticipationProbe probe;
      SubdivideReport report;
      const Mesh quads = quads_of(made, report);
      std::vector<std::uint32_t> got;
      for (const FaceId f : quads.faces())
        for (int k = 0; k < 4; ++k) got.push_back(quads.corner(f, k).value());
      if (threads == 1) {
        x = quads.xs();
        corners = got;
      } else {
        EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      }
      EXPECT_EQ(quads.xs(), x);
      EXPECT_EQ(got, corners);
    });
  }
}

TEST(Subdivide, NamesThePlaceOfATriangleTooFlatForDoubles) {
  // One unit in the last place high: midpoints have nowhere to go.
  const double y = 6700000.0;
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()}};
  Mesh mesh = build_mesh({0.0, 1.0, 0.5}, {y, y, std::nextafter(y, 1e9)}, faces);
  (void)ConstraintTags::add_to(mesh);
  SubdivideReport report;
  try {
    (void)subdivide(std::move(mesh), {}, report, Progress());
    FAIL() << "a flat triangle was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
    EXPECT_NE(error.message().find("6700000"), std::string::npos) << error.message();
  }
}

TEST(CutQuad, LeavesTwoValidTrianglesAndTheConstraintBits) {
  for (const int constrained : {0, 1, 2, 3}) {
    const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}};
    Mesh mesh = build_mesh({0, 3, 3, 0}, {0, 0, 1, 2}, faces);
    ConstraintTags tags = ConstraintTags::add_to(mesh);
    tags.set_constrained(SideId(FaceId(0U), constrained), true);
    const QuadCut cut = best_cut(mesh, FaceId(0U));
    ASSERT_TRUE(cut.valid());
    cut_quad(mesh, FaceId(0U), cut.from);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    const SideId s = mesh.find_side(VertexId(static_cast<std::uint32_t>(constrained)),
                                    VertexId(static_cast<std::uint32_t>((constrained + 1) % 4)));
    ASSERT_TRUE(s.valid());
    EXPECT_TRUE(tags.constrained(s));
    EXPECT_EQ(tags.sides[FaceId(0U)] != 0, s.face() == FaceId(0U));
  }
}

}  // namespace
}  // namespace quarry
