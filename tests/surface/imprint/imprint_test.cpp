#include "surface/imprint/imprint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "surface/feature/bind.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

struct Imprinted {
  RepairedSurface surface;
  std::vector<LineEdge> edges;
  ImprintReport report;

  [[nodiscard]] Vec3 at(std::uint32_t p) const { return surface.surface.points[p]; }
  [[nodiscard]] double length_of(std::int32_t line) const {
    double sum = 0;
    for (const LineEdge& edge : edges)
      if (edge.line == line) sum += length(at(edge.ends[1]) - at(edge.ends[0]));
    return sum;
  }
  [[nodiscard]] double area() const {
    double sum = 0;
    for (const SurfaceTriangle& t : surface.surface.triangles)
      sum += 0.5 * length(doubled_area(surface.surface, t));
    return sum;
  }
  // Points at which other than two of the edges meet.
  [[nodiscard]] std::size_t count_ends() const {
    std::vector<int> edges_at(surface.surface.points.size(), 0);
    for (const LineEdge& edge : edges)
      for (const std::uint32_t p : edge.ends) ++edges_at[p];
    return static_cast<std::size_t>(
        std::count_if(edges_at.begin(), edges_at.end(), [](int n) { return n != 0 && n != 2; }));
  }
};

Imprinted imprinted(TriangleSurface surface, const std::vector<SurfaceLine>& lines,
                    const ImprintOptions& options = {.step = 0.05, .snap = 1e-3, .reach = 0.05}) {
  Imprinted result;
  result.surface = repair_surface(std::move(surface), {});
  result.edges = imprint_lines(result.surface, lines, options, result.report);
  return result;
}

TriangleSurface plain() {
  return test::terrain(10, 10, [](double, double) { return 0.0; });
}
TriangleSurface hills() {
  return test::terrain(20, 20, [](double x, double y) { return 0.1 * std::sin(7 * x) * std::cos(5 * y); });
}

// Every edge lies in triangles, of which sheets can be made.
void expect_sound(const Imprinted& result, double area) {
  EXPECT_EQ(validate(make_sheets(result.surface), GeometryCheck::kNone), "");
  EXPECT_NEAR(result.area(), area, 1e-9);
  const SurfaceEdges edges(result.surface.surface);
  std::set<std::array<std::uint32_t, 2>> ends;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = SurfaceEdges::ends(result.surface.surface, edges.sides(e)[0]);
    ends.insert({std::min(a, b), std::max(a, b)});
  }
  for (const LineEdge& edge : result.edges) EXPECT_EQ(ends.count(edge.ends), 1U);
}

TEST(ImprintLines, CutAStraightLineIntoAPlain) {
  const Imprinted result = imprinted(plain(), {{{{0.13, 0.22, 0}, {0.87, 0.61, 0}}}});
  expect_sound(result, 1);
  EXPECT_NEAR(result.length_of(0), std::hypot(0.74, 0.39), 1e-3);
  EXPECT_EQ(result.count_ends(), 2U);
  EXPECT_EQ(result.report.imprinted, 1U);
  EXPECT_EQ(result.report.outside.count + result.report.lost.count, 0U);
}

TEST(ImprintLines, CrossInAPoint) {
  const Imprinted result =
      imprinted(plain(), {{{{0.1, 0.13, 0}, {0.9, 0.84, 0}}}, {{{0.12, 0.9, 0}, {0.87, 0.17, 0}}}});
  expect_sound(result, 1);
  // Four ends, and the crossing.
  EXPECT_EQ(result.count_ends(), 5U);
}

TEST(ImprintLines, GoThroughThePointsThatTheyComeNear) {
  const Imprinted result = imprinted(plain(), {{{{0.1, 0.3003, 0}, {0.9, 0.2998, 0}}}});
  EXPECT_NEAR(result.length_of(0), 0.8, 1e-12);
  // The points of the plain from (0.1, 0.3) to (0.9, 0.3).
  std::set<std::uint32_t> passed;
  for (const LineEdge& edge : result.edges) passed.insert(edge.ends.begin(), edge.ends.end());
  for (std::uint32_t i = 1; i < 10; ++i) EXPECT_EQ(passed.count(3 * 11 + i), 1U) << i;
}

TEST(ImprintLines, WithoutHeightsFollowTheHills) {
  const Imprinted result = imprinted(hills(), {{{{0.1, 0.4, 0}, {0.9, 0.47, 0}}, false}});
  expect_sound(result, imprinted(hills(), {}).area());
  EXPECT_GT(result.length_of(0), 0.81);
  EXPECT_EQ(result.count_ends(), 2U);
  // Over the straight line on the map.
  for (const LineEdge& edge : result.edges)
    for (const std::uint32_t p : edge.ends) {
      const Vec3 q = result.at(p);
      EXPECT_NEAR(q.y, 0.4 + 0.07 * (q.x - 0.1) / 0.8, 0.01);
    }
}

TEST(ImprintLines, WithHeightsGoAroundASphere) {
  std::vector<Vec3> circle;
  for (int i = 0; i <= 12; ++i) {
    const double angle = std::numbers::pi * i / 6;
    circle.push_back({0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6});
  }
  const Imprinted result = imprinted(test::sphere(4), {{circle}});
  EXPECT_EQ(validate(make_sheets(result.surface), GeometryCheck::kNone), "");
  EXPECT_NEAR(result.length_of(0), 2 * std::numbers::pi * 0.8, 0.05);
  EXPECT_EQ(result.count_ends(), 0U);
}

TEST(ImprintLines, EndAtTheRimOfTheSurface) {
  const Imprinted result = imprinted(plain(), {{{{0.53, 0.52, 0}, {0.61, 1.4, 0}}, false}});
  expect_sound(result, 1);
  EXPECT_EQ(result.report.outside.count, 1U);
  double top = 0;
  for (const LineEdge& edge : result.edges)
    for (const std::uint32_t p : edge.ends) top = std::max(top, result.at(p).y);
  EXPECT_EQ(top, 1);
}

TEST(ImprintLines, FarFromTheSurfaceAreLeftOut) {
  const Imprinted result = imprinted(plain(), {{{{0.1, 0.2, 3}, {0.9, 0.2, 3}}}});
  EXPECT_TRUE(result.edges.empty());
  EXPECT_EQ(result.report.imprinted, 0U);
}

TEST(ImprintLines, CutTheJoinsThatTheyCross) {
  // Along one sheet to the common edge, and on along another one.
  const double c = std::cos(2 * std::numbers::pi / 3), s = std::sin(2 * std::numbers::pi / 3);
  const Imprinted result =
      imprinted(test::three_sheets(), {{{{0.5, 0, 0.41}, {0, 0, 0.5}, {0.5 * c, 0.5 * s, 0.63}}}});
  expect_sound(result, 3);
  EXPECT_EQ(result.surface.joins.size(), 2U);
  EXPECT_EQ(result.count_ends(), 2U);
}

TEST(ImprintLines, BecomeCurvesWithTheirNumbers) {
  const Imprinted result =
      imprinted(plain(), {{{{0.1, 0.13, 0}, {0.9, 0.84, 0}}}, {{{0.12, 0.9, 0}, {0.87, 0.17, 0}}}});
  const auto features = find_feature_edges(result.surface, {}, result.edges).edges;
  const CurveNetwork network = make_curve_network(result.surface.surface, features, {});
  std::array<double, 2> lengths{};
  for (const FeatureCurve& curve : network.curves) {
    if (curve.kind != FeatureKind::kLine) continue;
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
      lengths.at(static_cast<std::size_t>(curve.line)) +=
          length(result.at(curve.points[i + 1]) - result.at(curve.points[i]));
  }
  EXPECT_NEAR(lengths[0], std::hypot(0.8, 0.71), 1e-3);
  EXPECT_NEAR(lengths[1], std::hypot(0.75, 0.73), 1e-3);
}

TEST(ImprintLines, LeaveASoundSurfaceWhateverTheyAre) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::uint64_t counter = 0;
    const auto draw = [&] { return uniform01(seed, counter++); };
    std::vector<SurfaceLine> lines;
    for (int i = 0; i < 12; ++i) {
      SurfaceLine line;
      line.has_heights = false;
      for (int k = 0; k < 4; ++k) line.points.push_back({1.2 * draw() - 0.1, 1.2 * draw() - 0.1, 0});
      lines.push_back(std::move(line));
    }
    const Imprinted result = imprinted(hills(), lines);
    EXPECT_EQ(validate(make_sheets(result.surface), GeometryCheck::kNone), "");
    EXPECT_NEAR(result.area(), imprinted(hills(), {}).area(), 1e-6);
    EXPECT_EQ(result.report.lost.count, 0U);
  }
}

}  // namespace
}  // namespace quarry
