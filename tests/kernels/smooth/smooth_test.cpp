#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/square_corners.hpp"
#include "kernels/smooth/star.hpp"
#include "tests/kernels/smooth/kept_places.hpp"
#include "tests/kernels/smooth/mean_quality.hpp"
#include "tests/kernels/smooth/quads_with_lines.hpp"
#include "tests/kernels/smooth/same_bits.hpp"

namespace quarry {
namespace {

using test::make_quads;
using test::mean_scaled_jacobian;
using test::QuadsWithLines;

// The worst face of the mesh, by the measure that guards the moves.
double worst_measure(const Mesh& mesh) {
  double worst = 1;
  Star star;
  for (const VertexId v : mesh.vertices()) {
    star.gather(mesh, v);
    star.weigh();
    worst = std::min(worst, star.worst());
  }
  return worst;
}

class SmoothingOf : public testing::TestWithParam<std::uint64_t> {
 protected:
  SmoothingOf() : quads_(make_quads({.seed = GetParam(), .slivers = GetParam() % 3 == 0 ? 0.02 : 0})) {}
  void smooth() {
    smooth_laplacian(quads_.mesh, quads_.lines, {}, Progress());
    square_corners(quads_.mesh, quads_.lines, {}, Progress());
    optimise_corners(quads_.mesh, quads_.lines, {}, Progress());
  }
  QuadsWithLines quads_;
};

TEST_P(SmoothingOf, QuadsImprovesTheMeanAndNeverTheWorstFaceForTheWorse) {
  const double mean = mean_scaled_jacobian(quads_.mesh);
  const double worst = worst_measure(quads_.mesh);
  smooth();
  EXPECT_EQ(validate(quads_.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(mean_scaled_jacobian(quads_.mesh), mean);
  EXPECT_GE(worst_measure(quads_.mesh), worst);
}

TEST_P(SmoothingOf, QuadsKeepsTheBitsOfFrozenVerticesAndSlidersOnTheirPieces) {
  test::expect_fixed_and_sliders_kept(quads_, [this] { smooth(); });
}

TEST_P(SmoothingOf, TrianglesImprovesTheMeanAndNeverTheWorstFaceForTheWorse) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  const double mean = mean_scaled_jacobian(made.mesh);
  const double worst = worst_measure(made.mesh);
  smooth_laplacian(made.mesh, made.lines, {}, Progress());
  EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(mean_scaled_jacobian(made.mesh), mean);
  EXPECT_GE(worst_measure(made.mesh), worst);
}

// The longest edge of each face by its shortest.
std::vector<double> edge_ratios(const Mesh& mesh) {
  std::vector<double> ratios;
  for (const FaceId f : mesh.faces()) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const double edge =
          distance(mesh.point(mesh.corner(f, k)), mesh.point(mesh.corner(f, (k + 1) % mesh.corner_count(f))));
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
    }
    ratios.push_back(longest / shortest);
  }
  return ratios;
}

TEST_P(SmoothingOf, NeedlesLeavesNoTriangleWithMoreUnequalEdges) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  for (const VertexId v : made.mesh.vertices()) {
    const Vec2 p = made.mesh.point(v);
    made.mesh.set_point(v, {p.x, 0.15 * p.y});
  }
  for (Vec2& node : made.lines.nodes.raw()) node.y *= 0.15;
  const std::vector<double> before = edge_ratios(made.mesh);
  const OptimiseOptions options{.target = 0.9};
  optimise_corners(made.mesh, made.lines, options, Progress());
  const std::vector<double> after = edge_ratios(made.mesh);
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_LE(after[i], std::max(options.largest_triangle_ratio, before[i]) * (1 + 1e-9)) << i;
}

INSTANTIATE_TEST_SUITE_P(Seeds, SmoothingOf, testing::Range<std::uint64_t>(1, 13));

TEST(Smoothing, GivesTheSameBitsOnAnyNumberOfThreads) {
  test::expect_same_bits_on_threads([](QuadsWithLines& quads) {
    smooth_laplacian(quads.mesh, quads.lines, {}, Progress());
    square_corners(quads.mesh, quads.lines, {}, Progress());
    optimise_corners(quads.mesh, quads.lines, {}, Progress());
  });
}

TEST(Smoothing, LooksOnceAtARegularMesh) {
  QuadsWithLines quads = make_quads({.jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
  EXPECT_EQ(smooth_laplacian(quads.mesh, quads.lines, {}, Progress()).visited, 0U);
  EXPECT_EQ(square_corners(quads.mesh, quads.lines, {}, Progress()).visited, 0U);
  EXPECT_EQ(optimise_corners(quads.mesh, quads.lines, {}, Progress()).visited, 0U);
}

TEST(Smoothing, NeverLowersTheWorstFaceOfAnyStarByOneMove) {
  // One vertex free at a time: its star is the only one that may change.
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    QuadsWithLines quads = make_quads({.columns = 8, .rows = 8, .seed = seed});
    ConstraintTags tags = ConstraintTags::of(quads.mesh);
    const std::vector<Support> support = tags.support.values().raw();
    Star star;
    for (const VertexId v : quads.mesh.vertices()) {
      for (Support& other : tags.support.values()) other = Support::fixed();
      tags.support[v] = support[v.value()];
      star.gather(quads.mesh, v);
      star.weigh();
      const double before = star.worst();
      smooth_laplacian(quads.mesh, quads.lines, {.sweeps = 1}, Progress());
      optimise_corners(quads.mesh, quads.lines, {.sweeps = 1, .target = 1}, Progress());
      star.gather(quads.mesh, v);
      star.weigh();
      EXPECT_GE(star.worst(), before);
    }
  }
}

TEST(SquareCorners, LiftsTheMeanAndKeepsFacesAboveTheFloor) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    QuadsWithLines quads =
        make_quads({.columns = 30, .rows = 30, .seed = seed, .jitter = 0.2, .flip_share = 0.05});
    smooth_laplacian(quads.mesh, quads.lines, {}, Progress());
    const double mean = mean_scaled_jacobian(quads.mesh);
    const double worst = worst_measure(quads.mesh);
    const SquareCornersOptions options;
    square_corners(quads.mesh, quads.lines, options, Progress());
    EXPECT_EQ(validate(quads.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_GT(mean_scaled_jacobian(quads.mesh), mean);
    EXPECT_GE(worst_measure(quads.mesh), std::min(worst, options.floor * options.floor));
  }
}

TEST(OptimiseCorners, LengthensAnEdgeThatShrankToATwentiethOfItsNeighbours) {
  const auto id = [](std::uint32_t i) { return VertexId(i); };
  const std::vector<FaceCorners> faces = {{id(0), id(1), id(4), id(3)},
                                          {id(1), id(2), id(5), id(4)},
                                          {id(3), id(4), id(7), id(6)},
                                          {id(4), id(5), id(8), id(7)}};
  Mesh mesh = build_mesh({0, 1, 2, 0, 1, 2, 0, 1, 2}, {0, 0, 0, 0.5, 0.05, 0.5, 1, 1, 1}, faces);
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (v != id(4)) tags.support[v] = Support::fixed();
  optimise_corners(mesh, {}, {.sweeps = 20}, Progress());
  for (const FaceId f : mesh.faces())
    EXPECT_LT(measure_face(mesh, f, [](auto... corners) { return edge_ratio(corners...); }), 4);
}

TEST(Star, MeasuresRectanglesByTheirAspectFromFiveOn) {
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}};
  double last = 2;
  for (const double aspect : {1.0, 4.8, 5.0, 8.0, 12.0, 100.0}) {
    const Mesh mesh = build_mesh({0, aspect, aspect, 0}, {0, 0, 1, 1}, faces);
    Star star;
    star.gather(mesh, VertexId(0U));
    star.weigh();
    if (aspect < 4.9) {
      EXPECT_EQ(star.worst(), 1.0);
    } else {
      EXPECT_LT(star.worst(), last);
    }
    last = star.worst();
  }
}

TEST(OptimiseCorners, OpensAThinRowFromEitherSideOfIt) {
  // The middle row lies 0.05 over the lowest one: no vertex can make a quad of the row wider by itself.
  const auto id = [](std::uint32_t i) { return VertexId(i); };
  const std::vector<FaceCorners> faces = {{id(0), id(1), id(4), id(3)},
                                          {id(1), id(2), id(5), id(4)},
                                          {id(3), id(4), id(7), id(6)},
                                          {id(4), id(5), id(8), id(7)}};
  Mesh mesh = build_mesh({0, 1, 2, 0, 1, 2, 0, 1, 2}, {0, 0, 0, 0.05, 0.05, 0.05, 1, 1, 1}, faces);
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  NodedLines lines;
  for (const VertexId v : mesh.vertices())
    if (v != id(4)) tags.support[v] = Support::fixed();
  for (const std::uint32_t end : {3U, 5U}) {
    const NodeId low = lines.nodes.push_back(mesh.point(id(end - 3)));
    const NodeId high = lines.nodes.push_back(mesh.point(id(end + 3)));
    tags.support[id(end)] = Support::on(lines.pieces.push_back({low, high, PieceKindOf::kOutline}));
  }
  optimise_corners(mesh, lines, {.sweeps = 20}, Progress());
  for (const FaceId f : mesh.faces())
    EXPECT_LT(measure_face(mesh, f, [](auto... corners) { return edge_ratio(corners...); }), 6);
}

TEST(OptimiseCorners, LengthensTheOneShortEdgeOfAQuadThatFillsAWedge) {
  // Only the end of the short edge that lies on a side of the wedge may move; no angle gains by it.
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}};
  Mesh mesh = build_mesh({0, 1.276, 2.113, 1.970}, {0, 0, 0.779, 1.047}, faces);
  const auto ratio = [&] {
    return measure_face(mesh, FaceId(0U), [](auto... corners) { return edge_ratio(corners...); });
  };
  ASSERT_GT(ratio(), 7);
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  NodedLines lines;
  for (const VertexId v : mesh.vertices()) tags.support[v] = Support::fixed();
  const NodeId tip = lines.nodes.push_back({0, 0});
  const NodeId end = lines.nodes.push_back({3.94, 2.094});
  tags.support[VertexId(3U)] = Support::on(lines.pieces.push_back({tip, end, PieceKindOf::kOutline}));
  optimise_corners(mesh, lines, {.sweeps = 20}, Progress());
  EXPECT_LT(ratio(), 6);
}

}  // namespace
}  // namespace quarry
