#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/pass.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/deferred/insert_nodes.hpp"
#include "kernels/deferred/insert_pieces.hpp"
#include "kernels/initial/crisscross.hpp"
#include "tests/support/noded_lines.hpp"

namespace quarry {
namespace {

struct Outcome {
  Mesh mesh;
  InsertedLines inserted;
  DeferredReport report;
};

Outcome insert(const NodedLines& lines, const Box2& box, DeferredOptions options) {
  Outcome outcome;
  outcome.mesh = make_crisscross(box, {.cell = options.spacing, .angle_degrees = 0});
  auto tags = ConstraintTags::add_to(outcome.mesh);
  for (const VertexId v : outcome.mesh.vertices())
    if (outcome.mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  outcome.inserted = insert_lines(outcome.mesh, lines, options, outcome.report, Progress());
  return outcome;
}

// Walks each piece along constrained edges from its first node to its last; "" or what is wrong.
std::string check_chains(const Outcome& outcome, const NodedLines& lines, double tolerance) {
  const auto tags = ConstraintTags::of(outcome.mesh);
  const Mesh& mesh = outcome.mesh;
  for (const PieceId id : IdRange<PieceId>(lines.pieces.size())) {
    const Piece& piece = lines.pieces[id];
    VertexId v = outcome.inserted.vertex_of_node[piece.from];
    const VertexId end = outcome.inserted.vertex_of_node[piece.to];
    if (mesh.point(v) != lines.nodes[piece.from]) return "a node lost its bits";
    const Vec2 a = lines.nodes[piece.from];
    const Vec2 d = lines.nodes[piece.to] - a;
    for (std::size_t steps = 0; v != end; ++steps) {
      VertexId next;
      for_each_side_around(mesh, v, [&](SideId s) {
        const VertexId u = mesh.target(s);
        const Vec2 r = mesh.point(u) - a;
        const bool ahead = dot(mesh.point(u) - mesh.point(v), d) > 0;
        const bool mine = u == end || tags.support[u] == Support::on(id);
        if (tags.constrained(s) && ahead && mine && std::abs(cross(r, d)) <= tolerance * length(d)) next = u;
      });
      if (!next.valid() || steps > mesh.vertex_slots())
        return "piece " + std::to_string(id.value()) + " is no chain";
      v = next;
    }
  }
  return {};
}

DeferredOptions with_spacing(double spacing) {
  DeferredOptions options;
  options.spacing = spacing;
  return options;
}

struct Case {
  std::string name;
  NodedLines lines;
};

std::vector<Case> hard_cases() {
  std::vector<Case> cases;
  const Vec2 center{50.3, 49.8};
  cases.push_back({"star of 8", test::star(center, 40, 8)});
  cases.push_back({"star of 64", test::star(center, 40, 64)});
  cases.push_back({"star of 360", test::star(center, 40, 360)});
  cases.push_back({"wedge of 0.05 degrees", test::star(center, 40, 2, 2 * 0.05 * std::numbers::pi / 180)});
  for (const double gap : {0.1, 0.01, 0.001})
    for (const double angle : {0.0, 0.3})
      cases.push_back({"comb at " + std::to_string(gap), test::comb({20.2, 30.1}, 50, gap, 10, angle)});
  cases.push_back({"lines along mesh edges", [] {
                     test::NodedLinesBuilder builder;
                     builder.polyline({{10, 10}, {90, 10}, {90, 90}, {10, 90}, {10, 10}});
                     builder.polyline({{20, 20}, {60, 60}, {80, 40}});
                     return builder.finish();
                   }()});
  cases.push_back({"lines through every second vertex", [] {
                     test::NodedLinesBuilder builder;
                     builder.piece({10, 12}, {70, 42});
                     builder.piece({11, 50}, {11, 90});
                     return builder.finish();
                   }()});
  cases.push_back({"a tiny triangle far smaller than the mesh", [] {
                     test::NodedLinesBuilder builder;
                     builder.polyline({{33.3, 33.3}, {33.301, 33.3}, {33.3, 33.301}, {33.3, 33.3}});
                     return builder.finish();
                   }()});
  return cases;
}

const Box2 kBox{{0, 0}, {100, 100}};

// One test a case, so that the long ones run side by side.
class HardCases : public testing::TestWithParam<std::size_t> {};

TEST_P(HardCases, EndInAValidMeshWithEachPieceAChain) {
  const Case hard = hard_cases()[GetParam()];
  SCOPED_TRACE(hard.name);
  const Outcome outcome = insert(hard.lines, kBox, with_spacing(2));
  EXPECT_EQ(validate(outcome.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(check_chains(outcome, hard.lines, 1e-9), "");
  EXPECT_LT(outcome.mesh.face_slots(), 400'000U);
}

TEST_P(HardCases, HaveTheSameGuaranteesWithThePaperPreset) {
  const Case hard = hard_cases()[GetParam()];
  SCOPED_TRACE(hard.name);
  const Outcome outcome = insert(hard.lines, kBox, paper_options(2));
  EXPECT_EQ(validate(outcome.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(check_chains(outcome, hard.lines, 1e-9), "");
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::Range(std::size_t{0}, hard_cases().size()));

TEST(InsertLines, RandomSoupsGiveTheSameValidMeshOnAnyNumberOfThreads) {
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL, 4ULL}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // Odd seeds lie at map coordinates of seven digits.
    const Vec2 origin = seed % 2 == 1 ? Vec2{465'000.25, 6'691'000.75} : Vec2{0, 0};
    const NodedLines lines = test::random_segments(seed, 400, 100, 0.05, origin);
    const Box2 box{origin, {origin.x + 100, origin.y + 100}};
    const Outcome serial = insert(lines, box, with_spacing(1));
    EXPECT_EQ(validate(serial.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(check_chains(serial, lines, 1e-8), "");
    for (const int threads : {1, 2, 4, 7}) {
      const parallel::ParticipationProbe probe(20);
      parallel::with_threads(threads, [&] {
        const Outcome other = insert(lines, box, with_spacing(1));
        EXPECT_EQ(other.mesh.xs(), serial.mesh.xs()) << threads;
        EXPECT_EQ(other.mesh.ys(), serial.mesh.ys()) << threads;
      });
      if (threads > 1) {
        EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      }
    }
  }
}

// A node that lies on the straight edge between two other nodes but for rounding: splitting the face that
// holds it would leave a triangle without height, which no quads can be made of.
TEST(InsertLines, PutsANodeBesideAnEdgeOntoThatEdge) {
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()},
                                          {VertexId(1U), VertexId(0U), VertexId(3U), VertexId()}};
  Mesh mesh = build_mesh({0, 1, 0.2, 0.8}, {0, 0.3, 1, -1}, faces);
  auto tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices()) tags.support[v] = Support::fixed();
  NodedLines lines;
  lines.nodes.push_back({0.5, std::nextafter(0.15, 1.0)});
  lines.line_begin.push_back(0);
  DeferredOptions options = with_spacing(2);
  options.max_tries = 0;  // straight to the fallback
  DeferredReport report;
  (void)insert_lines(mesh, lines, options, report, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.face_slots(), 4U);
  for (const FaceId f : mesh.faces())
    EXPECT_GT(
        orient2d(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)), mesh.point(mesh.corner(f, 2))),
        0.1);
}

TEST(InsertLines, AddsFurtherLinesToAMeshThatHasSome) {
  const NodedLines all = test::random_segments(11, 300, 100, 0.05, {0, 0});
  NodedLines first = all;
  const std::size_t half = all.pieces.size() / 2;
  first.pieces.resize(half);
  first.line_begin.resize(half + 1);
  // Pieces name their nodes in the order in which they were built, so the first half has the first nodes.
  first.nodes.resize(2 * half);
  Outcome outcome = insert(first, kBox, with_spacing(2));
  DeferredReport report;
  outcome.inserted = insert_lines(outcome.mesh, all, with_spacing(2), report, Progress(), outcome.inserted);
  EXPECT_EQ(report.pieces.won > 0, true);
  EXPECT_EQ(validate(outcome.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(check_chains(outcome, all, 1e-9), "");
}

TEST(InsertLines, IsTheSameWithWinnersAppliedInReverse) {
  // The passes of the kernel have no switch for that; their operations are run by hand here.
  const NodedLines lines = test::random_segments(5, 200, 100, 0.05, {0, 0});
  const Box2 box = kBox;
  std::vector<std::vector<double>> xs;
  for (const bool reverse : {false, true}) {
    Mesh mesh = make_crisscross(box, {.cell = 2, .angle_degrees = 0});
    auto tags = ConstraintTags::add_to(mesh);
    for (const VertexId v : mesh.vertices())
      if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
    const DeferredOptions options = with_spacing(2);
    deferred::State state(lines, options, tags);
    std::vector<NodeId> nodes;
    for (const NodeId node : IdRange<NodeId>(lines.nodes.size())) {
      nodes.push_back(node);
      state.near_node[node] = VertexId(0U);
    }
    const PassOptions pass{.window = 512, .cutoff = 2, .reverse = reverse};
    run_pass(mesh, deferred::NodeInsertion(state), nodes, pass, Progress());
    std::vector<PieceId> pieces;
    for (const PieceId piece : IdRange<PieceId>(lines.pieces.size())) {
      pieces.push_back(piece);
      state.front[piece] = state.vertex_of_node[lines.pieces[piece].from];
    }
    run_pass(mesh, deferred::PieceInsertion(state), pieces, pass, Progress());
    xs.push_back(mesh.xs());
  }
  EXPECT_EQ(xs[0], xs[1]);
}

TEST(InsertLines, KeepsToItsClaims) {
#ifndef QUARRY_CHECK_CLAIMS
  GTEST_SKIP() << "claims are checked in builds with QUARRY_CHECK_CLAIMS";
#endif
  reset_claim_violations();
  for (const Case& hard : hard_cases()) (void)insert(hard.lines, kBox, with_spacing(2));
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

TEST(InsertLines, NamesThePlaceWhereTwoPiecesCross) {
  test::NodedLinesBuilder builder;
  builder.piece({10, 10}, {90, 90});
  builder.piece({10, 90}, {90, 10});
  try {
    (void)insert(builder.finish(), kBox, with_spacing(2));
    FAIL() << "crossing pieces were accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
    EXPECT_NE(error.message().find("clean the lines"), std::string::npos);
  }
}

TEST(InsertLines, EndsWhenTheMeshOutgrowsItsBudget) {
  DeferredOptions options = with_spacing(2);
  options.max_faces = 20'000;
  try {
    (void)insert(test::star({50.3, 49.8}, 40, 360), kBox, options);
    FAIL() << "the budget was not kept";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBudget);
  }
}

TEST(InsertLines, RefusesAPointOutsideTheMesh) {
  test::NodedLinesBuilder builder;
  builder.piece({10, 10}, {190, 90});
  try {
    (void)insert(builder.finish(), kBox, with_spacing(2));
    FAIL() << "a point outside was accepted";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("(190, 90)"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace quarry
