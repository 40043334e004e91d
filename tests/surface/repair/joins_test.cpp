#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "surface/repair/coarsen_joins.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/split_joins.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

// All of one group, with the common edge cut into pieces of at most that length, and bent by so much.
RepairedSurface sheets_with_a_join(double longest, double bend) {
  TriangleSurface surface = test::three_sheets();
  surface.groups.assign(surface.triangles.size(), 0);
  RepairedSurface repaired = repair_surface(std::move(surface), {});
  split_joins(repaired, longest);
  for (Vec3& p : repaired.surface.points)
    if (p.x == 0 && p.y == 0) p.x = bend * std::sin(3 * p.z);
  return repaired;
}

double area_of(const TriangleSurface& surface) {
  double area = 0;
  for (const SurfaceTriangle& t : surface.triangles) area += 0.5 * length(doubled_area(surface, t));
  return area;
}

double longest_join(const RepairedSurface& repaired) {
  double longest = 0;
  for (const auto& [a, b] : repaired.joins)
    longest = std::max(longest, length(repaired.surface.points[b] - repaired.surface.points[a]));
  return longest;
}

TEST(SplitJoins, LeavesNoneThatIsTooLong) {
  const RepairedSurface repaired = sheets_with_a_join(0.07, 0);
  EXPECT_EQ(repaired.joins.size(), 16U);
  EXPECT_EQ(longest_join(repaired), 1.0 / 16);
  EXPECT_NEAR(area_of(repaired.surface), 3, 1e-12);
}

TEST(HalveJoins, HalvesEachOnce) {
  RepairedSurface repaired = sheets_with_a_join(0.3, 0.1);
  const double longest = longest_join(repaired);
  EXPECT_EQ(repaired.joins.size(), 4U);
  halve_joins(repaired);
  EXPECT_EQ(repaired.joins.size(), 8U);
  EXPECT_NEAR(longest_join(repaired), 0.5 * longest, 1e-12);
  EXPECT_TRUE(std::is_sorted(repaired.joins.begin(), repaired.joins.end()));
  EXPECT_EQ(validate(make_sheets(repaired), GeometryCheck::kNone), "");
}

TEST(CoarsenJoins, LengthensAStraightJoinAndKeepsTheSheets) {
  RepairedSurface repaired = sheets_with_a_join(0.02, 0);
  const auto before = static_cast<std::uint64_t>(repaired.joins.size());
  const std::uint64_t collapses =
      coarsen_joins(repaired, {.shortest = 0.2, .longest = 0.3, .deviation = 1e-9});
  EXPECT_EQ(repaired.joins.size(), before - collapses);
  EXPECT_LE(repaired.joins.size(), 9U);
  EXPECT_LE(longest_join(repaired), 0.3);
  EXPECT_TRUE(std::is_sorted(repaired.joins.begin(), repaired.joins.end()));
  EXPECT_NEAR(area_of(repaired.surface), 3, 1e-12);
  EXPECT_EQ(validate(make_sheets(repaired), GeometryCheck::kNone), "");
}

TEST(CoarsenJoins, KeepsACurvedJoinWithinTheDeviation) {
  RepairedSurface repaired = sheets_with_a_join(0.02, 0.2);
  const double deviation = 0.005;
  coarsen_joins(repaired, {.shortest = 0.5, .longest = 1, .deviation = deviation});
  EXPECT_LT(repaired.joins.size(), 20U);
  std::vector<Vec3> course;
  for (const auto& join : repaired.joins)
    for (const std::uint32_t p : join) course.push_back(repaired.surface.points[p]);
  for (double z = 0; z <= 1; z += 0.01) {
    const Vec3 p{0.2 * std::sin(3 * z), 0, z};
    double nearest = 1;
    for (std::size_t i = 0; i < course.size(); i += 2) {
      const Vec3 d = course[i + 1] - course[i];
      const double share = std::clamp(dot(p - course[i], d) / dot(d, d), 0.0, 1.0);
      nearest = std::min(nearest, length(p - (course[i] + share * d)));
    }
    EXPECT_LE(nearest, deviation + 1e-3) << z;
  }
}

TEST(CoarsenJoins, LeavesASurfaceWithoutJoinsAlone) {
  RepairedSurface repaired = repair_surface(test::sphere(2), {});
  const TriangleSurface before = repaired.surface;
  EXPECT_EQ(coarsen_joins(repaired, {.shortest = 1, .longest = 1, .deviation = 1}), 0U);
  EXPECT_EQ(repaired.surface.triangles, before.triangles);
}

}  // namespace
}  // namespace quarry
