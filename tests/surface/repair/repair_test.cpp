#include "surface/repair/repair.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "surface/repair/fill_holes.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/surface_edges.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

// Each triangle with points of its own, as STL files have them.
TriangleSurface exploded(const TriangleSurface& surface) {
  TriangleSurface result;
  for (const SurfaceTriangle& t : surface.triangles) {
    const auto base = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t p : t) result.points.push_back(surface.points[p]);
    result.triangles.push_back({base, base + 1, base + 2});
  }
  result.groups.assign(result.triangles.size(), 0);
  return result;
}

double volume_of(const TriangleSurface& surface) {
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles)
    volume += dot(surface.points[a], cross(surface.points[b], surface.points[c])) / 6;
  return volume;
}

TEST(Repair, WeldsEqualPointsOfLooseTriangles) {
  const RepairedSurface repaired = repair_surface(exploded(test::cube()), {});
  EXPECT_EQ(repaired.surface.points.size(), 8U);
  EXPECT_EQ(repaired.report.welded.count, 28U);
  EXPECT_EQ(repaired.report.unused.count, 0U);
  EXPECT_EQ(repaired.report.open_edges, 0U);
}

TEST(Repair, WeldsNearPointsWithinTheDistanceOnly) {
  TriangleSurface loose = exploded(test::cube());
  for (std::size_t i = 0; i < loose.points.size(); ++i)
    loose.points[i].x += 1e-6 * static_cast<double>(i % 3);
  EXPECT_GT(repair_surface(loose, {}).report.open_edges, 0U);
  EXPECT_EQ(repair_surface(loose, {.weld = 1e-5}).report.open_edges, 0U);
  EXPECT_EQ(repair_surface(loose, {.weld = 1e-5}).surface.points.size(), 8U);
}

TEST(Repair, DropsFlatTrianglesThatHangOnAnEdgeAndKeepsThoseThatFillATJunction) {
  TriangleSurface hanging = test::cube();
  hanging.points.push_back(
      0.5 * (hanging.points[hanging.triangles[0][0]] + hanging.points[hanging.triangles[0][1]]));
  hanging.triangles.push_back({hanging.triangles[0][0], 8, hanging.triangles[0][1]});
  hanging.groups.assign(hanging.triangles.size(), 0);
  const RepairedSurface repaired = repair_surface(hanging, {});
  EXPECT_EQ(repaired.report.hanging.count, 1U);
  EXPECT_EQ(repaired.report.branches.count, 0U);
  EXPECT_EQ(repaired.surface.triangles.size(), 12U);

  // One triangle beside two whose sides end in the middle of its own.
  const TriangleSurface filled = test::surface_of({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                                                  {{0, 1, 2}, {0, 3, 1}, {0, 4, 3}, {3, 4, 1}});
  EXPECT_EQ(repair_surface(filled, {}).report.hanging.count, 0U);
  EXPECT_EQ(repair_surface(filled, {}).surface.triangles.size(), 4U);
}

TEST(Repair, CutsWhatLiesAcrossTheLongestEdgeOfAFlatTriangle) {
  // A square of four triangles, one of which has its points in a row, but for rounding.
  for (const double off : {0.0, 1e-16, -1e-16}) {
    const RepairedSurface repaired =
        repair_surface(test::surface_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, off}},
                                        {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}),
                       {});
    EXPECT_EQ(repaired.report.caps.count, 1U);
    EXPECT_EQ(repaired.report.flat.count, 0U);
    EXPECT_EQ(repaired.report.open_edges, 4U);
    ASSERT_EQ(repaired.surface.triangles.size(), 4U);
    for (const SurfaceTriangle& t : repaired.surface.triangles)
      EXPECT_NEAR(length(doubled_area(repaired.surface, t)), 0.5, 1e-9);
  }
}

TEST(Repair, CutsAtFlatTrianglesThatLieUponOneAnother) {
  // Of five points in a row, fanned from the first, between a large triangle and four.
  const RepairedSurface repaired = repair_surface(
      test::surface_of(
          {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 2, 0}, {2, -2, 0}},
          {{0, 4, 5}, {0, 3, 4}, {0, 2, 3}, {0, 1, 2}, {1, 0, 6}, {2, 1, 6}, {3, 2, 6}, {4, 3, 6}}),
      {});
  EXPECT_EQ(repaired.report.caps.count, 3U);
  EXPECT_EQ(repaired.surface.triangles.size(), 8U);
  EXPECT_EQ(repaired.report.open_edges, 4U);
}

TEST(Repair, DropsDegenerateAndDuplicateTrianglesAndTellsWhere) {
  TriangleSurface cube = test::cube();
  cube.triangles.push_back({3, 2, 0});  // there already, the other way round
  cube.triangles.push_back({1, 1, 5});
  cube.points.push_back({9, 9, 9});
  cube.groups.assign(cube.triangles.size(), 0);
  const RepairedSurface repaired = repair_surface(cube, {});
  EXPECT_EQ(repaired.surface.triangles.size(), 12U);
  EXPECT_EQ(repaired.report.duplicate.count, 1U);
  EXPECT_EQ(repaired.report.degenerate.count, 1U);
  ASSERT_EQ(repaired.report.unused.count, 1U);
  EXPECT_EQ(repaired.report.unused.places.front(), (Vec3{9, 9, 9}));
}

TEST(Repair, TurnsTheFewerTriangles) {
  TriangleSurface cube = test::cube();
  for (const std::size_t t : {1U, 4U, 9U}) std::swap(cube.triangles[t][0], cube.triangles[t][1]);
  const RepairedSurface repaired = repair_surface(cube, {});
  EXPECT_EQ(repaired.report.turned.count, 3U);
  EXPECT_DOUBLE_EQ(volume_of(repaired.surface), 1.0);
}

TEST(Repair, CutsAOneSidedSurfaceOnceAcross) {
  const RepairedSurface repaired = repair_surface(test::moebius(24), {});
  EXPECT_GT(repaired.report.seams.count, 0U);
  const Mesh mesh = make_sheets(repaired);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  // A band of one side has one rim; cut open it is a disk.
  const auto edges =
      static_cast<std::int64_t>(SurfaceEdges(repaired.surface).count() + repaired.report.seams.count);
  EXPECT_EQ(static_cast<std::int64_t>(mesh.count_alive_vertices()) - edges +
                static_cast<std::int64_t>(mesh.count_alive_faces()),
            1);
}

TEST(Repair, KeepsSheetsThatShareAnEdge) {
  const RepairedSurface repaired = repair_surface(test::three_sheets(), {});
  EXPECT_EQ(repaired.report.branches.count, 1U);
  ASSERT_EQ(repaired.joins.size(), 1U);
  EXPECT_EQ(repaired.joins.front(), (SheetJoin{0, 1}));
  const Mesh mesh = make_sheets(repaired);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  EXPECT_EQ(mesh.count_alive_vertices(), 12U);
}

TEST(Repair, SplitsAPointInWhichTwoPartsTouch) {
  // Two tetrahedra tip to tip.
  const TriangleSurface hourglass = test::surface_of(
      {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}},
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
  const RepairedSurface repaired = repair_surface(hourglass, {});
  EXPECT_TRUE(repaired.joins.empty());
  EXPECT_EQ(repaired.report.pinches.count, 1U);
  const Mesh mesh = make_sheets(repaired);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  EXPECT_EQ(mesh.count_alive_vertices(), 8U);
  const auto point = mesh.find_tag<VertexId, std::uint32_t>(kSurfacePointTag);
  EXPECT_EQ(point[VertexId(std::size_t{0})], 0U);
  EXPECT_EQ(point[VertexId(std::size_t{7})], 0U);
}

TEST(Repair, FillsHolesOnlyWhenAskedAndOnlySmallOnes) {
  TriangleSurface open = test::sphere(2);
  open.triangles.erase(open.triangles.begin() + 5);
  open.triangles.erase(open.triangles.begin() + 39, open.triangles.begin() + 43);
  open.groups.assign(open.triangles.size(), 0);
  EXPECT_EQ(repair_surface(open, {}).report.holes, 2U);
  EXPECT_EQ(repair_surface(open, {.fill_holes = 3}).report.holes, 1U);
  const RepairedSurface closed = repair_surface(open, {.fill_holes = 100});
  EXPECT_EQ(closed.report.holes, 0U);
  EXPECT_EQ(closed.report.filled_holes.count, 2U);
  EXPECT_NEAR(volume_of(closed.surface), volume_of(test::sphere(2)), 0.1);
  EXPECT_EQ(validate(make_sheets(closed), GeometryCheck::kNone), "");
}

TEST(Repair, RefusesASurfaceWithoutTriangles) {
  EXPECT_THROW((void)repair_surface(test::surface_of({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}), {}), Error);
  EXPECT_THROW((void)repair_surface(test::surface_of({{0, 0, 0}}, {{0, 1, 2}}), {}), Error);
}

}  // namespace
}  // namespace quarry
