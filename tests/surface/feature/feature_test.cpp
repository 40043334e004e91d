#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "surface/feature/bind.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/feature/feature_edges.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

std::size_t count(const std::vector<FeatureEdge>& edges, FeatureKind kind) {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](const FeatureEdge& e) { return e.kind == kind; }));
}

CurveNetwork network_of(const RepairedSurface& repaired, const FeatureOptions& options) {
  return make_curve_network(repaired.surface, find_feature_edges(repaired, options).edges, options);
}

TEST(FeatureEdges, OfACubeAreItsTwelve) {
  const RepairedSurface repaired = repair_surface(test::cube(), {});
  const auto edges = find_feature_edges(repaired, {}).edges;
  EXPECT_EQ(edges.size(), 12U);
  EXPECT_EQ(count(edges, FeatureKind::kSharp), 12U);
  const CurveNetwork network = network_of(repaired, {});
  EXPECT_EQ(network.nodes.size(), 8U);
  EXPECT_EQ(network.curves.size(), 12U);
}

TEST(FeatureEdges, OfASmoothSphereAreNone) {
  EXPECT_TRUE(find_feature_edges(repair_surface(test::sphere(4), {}), {}).edges.empty());
}

TEST(FeatureEdges, OfPolyhedraWithATriangleForEachFaceAreAllEdges) {
  const RepairedSurface octahedron = repair_surface(test::sphere(0), {});
  EXPECT_EQ(find_feature_edges(octahedron, {.size = 0.1}).edges.size(), 12U);
  const RepairedSurface pyramid = repair_surface(test::cone(4, 1, 1), {});
  EXPECT_EQ(count(find_feature_edges(pyramid, {.size = 0.1}).edges, FeatureKind::kSharp), 4U);
}

TEST(FeatureEdges, NameRimsBordersAndJoins) {
  TriangleSurface flat = test::terrain(8, 8, [](double, double) { return 0.0; });
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) flat.groups[t] = t < 64 ? 0 : 1;
  const auto edges = find_feature_edges(repair_surface(flat, {}), {}).edges;
  EXPECT_EQ(count(edges, FeatureKind::kRim), 32U);
  EXPECT_EQ(count(edges, FeatureKind::kBorder), 8U);
  EXPECT_EQ(count(find_feature_edges(repair_surface(test::three_sheets(), {}), {}).edges, FeatureKind::kJoin),
            1U);
}

// A ring of points, of which every second lies in the middle between its neighbours.
TEST(CurveNetwork, HasANodeAtEachBendWhereItIsToBeStraight) {
  TriangleSurface fan;
  const std::uint32_t corners = 12;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const auto at = [](std::uint32_t k) {
      const double turn = 2 * std::numbers::pi * k / corners;
      return Vec3{std::cos(turn), std::sin(turn), 0.1 * std::cos(2 * turn)};
    };
    fan.points.push_back(0.5 * (at(i) + at(i + corners - 1)));
    fan.points.push_back(at(i));
  }
  fan.points.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < 2 * corners; ++i)
    fan.triangles.push_back({i, (i + 1) % (2 * corners), 2 * corners});
  fan.groups.assign(fan.triangles.size(), 0);
  const RepairedSurface repaired = repair_surface(fan, {});
  const auto edges = find_feature_edges(repaired, {.sharp_degrees = 180}).edges;
  EXPECT_EQ(make_curve_network(repaired.surface, edges, {}).nodes.size(), 0U);
  const FeatureOptions straight{.straightness = 1e-12};
  const CurveNetwork network = make_curve_network(repaired.surface, edges, straight);
  EXPECT_EQ(network.nodes.size(), corners);
  for (const FeatureCurve& curve : network.curves) EXPECT_EQ(curve.points.size(), 3U);
  const std::vector<std::uint32_t> more = {0, 4, 2 * corners};
  EXPECT_EQ(make_curve_network(repaired.surface, edges, straight, more).nodes.size(), corners + 3);
}

TEST(CurveNetwork, KnowsTheCurveUnderEachOfItsEdges) {
  const CurveNetwork network = network_of(repair_surface(test::cube(), {}), {});
  for (const PieceId id : IdRange<PieceId>(network.curves.size())) {
    const std::vector<Vec3>& points = network.curves[id].course.points();
    const Vec3 middle = 0.5 * (points.front() + points.back());
    std::vector<Support> ends;
    for (const NodeId n : IdRange<NodeId>(network.nodes.size()))
      for (const std::uint32_t p : {network.curves[id].points.front(), network.curves[id].points.back()})
        if (network.nodes[n] == p) ends.push_back(Support::at(n));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_EQ(network.under_edge(ends[0], ends[1], middle), id);
    EXPECT_EQ(network.under_edge(Support::on(id), ends[1], middle), id);
  }
}

TEST(FeatureEdges, AreNoneWithinAFace) {
  // Two triangles that are one bent face.
  const RepairedSurface bent = repair_surface(
      test::surface_of({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}), {});
  const std::vector<SheetJoin> within = {{0, 2}};
  EXPECT_EQ(count(find_feature_edges(bent, {.sharp_degrees = 30}).edges, FeatureKind::kSharp), 1U);
  EXPECT_EQ(count(find_feature_edges(bent, {.sharp_degrees = 30}, {}, within).edges, FeatureKind::kSharp),
            0U);
}

TEST(FeatureEdges, OfAFoldGoOnWhereItFades) {
  // A crest whose turn falls from 80 degrees to nothing along x.
  const auto height = [](double x, double y) { return (1 - x) * (0.5 - std::abs(y - 0.5)); };
  const RepairedSurface repaired = repair_surface(test::terrain(40, 40, height), {});
  FeatureOptions options{.sharp_degrees = 40, .size = 0.05};
  double reach = 0, sharp_reach = 0;
  for (const FeatureEdge& e : find_feature_edges(repaired, options).edges)
    if (e.kind == FeatureKind::kSharp)
      for (const std::uint32_t p : e.ends) reach = std::max(reach, repaired.surface.points[p].x);
  options.weakest_share = 1;
  for (const FeatureEdge& e : find_feature_edges(repaired, options).edges)
    if (e.kind == FeatureKind::kSharp)
      for (const std::uint32_t p : e.ends) sharp_reach = std::max(sharp_reach, repaired.surface.points[p].x);
  EXPECT_GT(sharp_reach, 0.4);
  EXPECT_GT(reach, sharp_reach + 0.1);
}

TEST(FeatureEdges, OfNoiseAreLeftOut) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed 7");
  const auto height = [&](double x, double y) {
    return 0.008 * uniform01(seed, static_cast<std::uint64_t>(1000 * x) * 1009 +
                                       static_cast<std::uint64_t>(1000 * y));
  };
  const RepairedSurface repaired = repair_surface(test::terrain(60, 60, height), {});
  const FeatureOptions unscaled{.sharp_degrees = 40};
  const FeatureOptions scaled{.sharp_degrees = 40, .size = 0.1};
  EXPECT_EQ(count(find_feature_edges(repaired, {}).edges, FeatureKind::kSharp), 0U);
  const std::size_t all = count(find_feature_edges(repaired, unscaled).edges, FeatureKind::kSharp);
  const std::size_t kept = count(find_feature_edges(repaired, scaled).edges, FeatureKind::kSharp);
  EXPECT_GT(all, 20U);
  EXPECT_LT(10 * kept, all);
}

TEST(CurveNetwork, FindsCornersOfARimAtTheScaleOfTheMesh) {
  // A square whose rim has teeth of a hundredth.
  TriangleSurface flat = test::terrain(100, 100, [](double, double) { return 0.0; });
  for (Vec3& p : flat.points)
    if (p.y == 0 && p.x > 0 && p.x < 1 && static_cast<int>(std::lround(100 * p.x)) % 2 == 1) p.y = 0.008;
  const RepairedSurface repaired = repair_surface(flat, {});
  EXPECT_GT(network_of(repaired, {}).nodes.size(), 50U);
  const CurveNetwork network = network_of(repaired, {.size = 0.1});
  EXPECT_EQ(network.nodes.size(), 4U);
}

TEST(CurveNetwork, HasANodeAtTheApexOfAConeHoweverItIsCut) {
  for (const auto& [sectors, rings] : {std::pair{64U, 1U}, std::pair{24U, 6U}, std::pair{48U, 60U}}) {
    SCOPED_TRACE(rings);
    const CurveNetwork network = network_of(repair_surface(test::cone(sectors, rings, 2), {}), {.size = 0.1});
    EXPECT_EQ(network.nodes.size(), 1U);
    EXPECT_EQ(network.nodes[NodeId(0U)], 0U);
    EXPECT_EQ(network.curves.size(), 1U);  // the rim
  }
}

TEST(CurveNetwork, HasNoNodeAtTipsThatAreBluntOrSmallerThanAnElement) {
  EXPECT_TRUE(network_of(repair_surface(test::cone(64, 1, 0.5), {}), {.size = 0.1}).nodes.empty());
  EXPECT_TRUE(network_of(repair_surface(test::sphere(4), {}), {.size = 0.1}).nodes.empty());
  const auto tooth = [](double x, double y) { return std::max(0.0, 0.1 - 3 * std::hypot(x - 0.5, y - 0.5)); };
  const RepairedSurface plate = repair_surface(test::terrain(60, 60, tooth), {});
  EXPECT_EQ(network_of(plate, {.sharp_degrees = 180, .size = 0.02}).nodes.size(), 4U + 1U);
  EXPECT_EQ(network_of(plate, {.sharp_degrees = 180, .size = 0.2}).nodes.size(), 4U);
}

TEST(CurveNetwork, ProjectsToTheNearestPlaceOfACurve) {
  const RepairedSurface repaired = repair_surface(test::cube(2), {});
  const CurveNetwork network = network_of(repaired, {});
  for (const PieceId c : IdRange<PieceId>(network.curves.size())) {
    const auto& points = network.curves[c].course.points();
    const Vec3 middle = 0.5 * (points.front() + points.back());
    EXPECT_EQ(network.project(c, middle + 0.1 * (middle - Vec3{1, 1, 1})), middle);
  }
}

TEST(Polyline3, FindsTheNearestPointAsALookAtAllSegmentsDoes) {
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL}) {
    SCOPED_TRACE(seed);
    std::uint64_t counter = 0;
    const auto draw = [&] { return uniform01(seed, counter++); };
    std::vector<Vec3> points;
    for (int i = 0; i < 57; ++i) points.push_back({draw(), draw(), draw()});
    const Polyline3 line(points);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p{2 * draw() - 0.5, draw(), draw()};
      double least = 1e9;
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        least = std::min(least, length(Polyline3({points[k], points[k + 1]}).nearest(p) - p));
      EXPECT_EQ(length(line.nearest(p) - p), least);
    }
  }
}

TEST(BindFeatures, ConstrainsTheSidesOfAllSheets) {
  const RepairedSurface repaired = repair_surface(test::three_sheets(), {});
  Mesh mesh = make_sheets(repaired);
  const ConstraintTags tags = bind_features(mesh, network_of(repaired, {}));
  std::size_t constrained = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) constrained += tags.constrained(SideId(f, k)) ? 1 : 0;
  EXPECT_EQ(constrained, 12U);
  for (const VertexId v : mesh.vertices()) EXPECT_TRUE(tags.support[v].is_fixed());
}

}  // namespace
}  // namespace quarry
