#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "surface/join/divide_joins.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

// All of one group, with the common edge, one long, halved so often, and bent by so much.
RepairedSurface sheets_with_a_join(int halvings, double bend) {
  TriangleSurface surface = test::three_sheets();
  surface.groups.assign(surface.triangles.size(), 0);
  RepairedSurface repaired = repair_surface(std::move(surface), {});
  for (int k = 0; k < halvings; ++k) halve_joins(repaired);
  for (Vec3& p : repaired.surface.points)
    if (p.x == 0 && p.y == 0) p.x = bend * std::sin(3 * p.z);
  return repaired;
}

DivideJoinsOptions parts_of(double edge, double deviation) {
  return {.edge = edge, .deviation = deviation, .corners = {.size = edge}};
}

double longest_join(const RepairedSurface& repaired) {
  double longest = 0;
  for (const auto& [a, b] : repaired.joins)
    longest = std::max(longest, length(repaired.surface.points[b] - repaired.surface.points[a]));
  return longest;
}

double shortest_join(const RepairedSurface& repaired) {
  double shortest = 1;
  for (const auto& [a, b] : repaired.joins)
    shortest = std::min(shortest, length(repaired.surface.points[b] - repaired.surface.points[a]));
  return shortest;
}

TEST(HalveJoins, HalvesEachOnce) {
  RepairedSurface repaired = sheets_with_a_join(2, 0.1);
  const double longest = longest_join(repaired);
  EXPECT_EQ(repaired.joins.size(), 4U);
  halve_joins(repaired);
  EXPECT_EQ(repaired.joins.size(), 8U);
  EXPECT_NEAR(longest_join(repaired), 0.5 * longest, 1e-12);
  EXPECT_TRUE(std::is_sorted(repaired.joins.begin(), repaired.joins.end()));
  EXPECT_EQ(validate(make_sheets(repaired), GeometryCheck::kNone), "");
}

TEST(DivideJoins, MakesEqualPartsOfAStraightJoinWhateverItWasMadeOf) {
  for (const int halvings : {0, 2, 4, 6}) {
    RepairedSurface repaired = sheets_with_a_join(halvings, 0);
    divide_joins(repaired, parts_of(0.15, 1e-9));
    ASSERT_EQ(repaired.joins.size(), 7U) << halvings;
    EXPECT_NEAR(longest_join(repaired), 1.0 / 7, 2 * 0.05 * 0.15);
    EXPECT_NEAR(shortest_join(repaired), 1.0 / 7, 2 * 0.05 * 0.15);
    EXPECT_TRUE(std::is_sorted(repaired.joins.begin(), repaired.joins.end()));
    EXPECT_NEAR(area_of(repaired.surface), 3, 1e-12);
    EXPECT_EQ(validate(make_sheets(repaired), GeometryCheck::kNone), "");
  }
}

TEST(DivideJoins, KeepsACurvedJoinWithinTheDeviation) {
  RepairedSurface repaired = sheets_with_a_join(6, 0.2);
  const double deviation = 0.005;
  divide_joins(repaired, parts_of(0.25, deviation));
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

TEST(DivideJoins, KeepsCornersOfAJoin) {
  RepairedSurface repaired = sheets_with_a_join(3, 0);
  const Vec3 corner{0.3, 0, 0.375};
  for (Vec3& p : repaired.surface.points)
    if (p.x == 0 && p.y == 0) p.x = p.z <= 0.375 ? 0.8 * p.z : 0.3 - 0.48 * (p.z - 0.375);
  divide_joins(repaired, parts_of(0.2, 0.2));
  const auto is_corner = [&](std::uint32_t p) { return length(repaired.surface.points[p] - corner) < 1e-12; };
  EXPECT_EQ(std::count_if(repaired.joins.begin(), repaired.joins.end(),
                          [&](const SheetJoin& join) { return is_corner(join[0]) || is_corner(join[1]); }),
            2);
}

TEST(DivideJoins, LeavesASurfaceWithoutJoinsAlone) {
  RepairedSurface repaired = repair_surface(test::sphere(2), {});
  const TriangleSurface before = repaired.surface;
  divide_joins(repaired, parts_of(1, 1));
  EXPECT_EQ(repaired.surface.triangles, before.triangles);
}

}  // namespace
}  // namespace quarry
