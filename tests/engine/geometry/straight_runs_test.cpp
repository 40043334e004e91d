#include "engine/geometry/straight_runs.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

using Cuts = std::vector<std::uint32_t>;

Cuts bends(const std::vector<Vec2>& points, double tolerance = 1e-9) { return find_bends(points, tolerance); }

TEST(StraightRuns, AStraightLineIsOne) {
  EXPECT_EQ(bends({{0, 0}, {0.1, 0.1}, {0.3, 0.3}, {1, 1}}), (Cuts{0, 3}));
}

TEST(StraightRuns, EndAtEachBend) {
  EXPECT_EQ(bends({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}), (Cuts{0, 2, 4, 5}));
}

TEST(StraightRuns, PassOverBendsWithinTheTolerance) {
  const std::vector<Vec2> wavy = {{0, 0}, {1, 0.01}, {2, -0.01}, {3, 0}};
  EXPECT_EQ(bends(wavy), (Cuts{0, 1, 2, 3}));
  EXPECT_EQ(bends(wavy, 0.02), (Cuts{0, 3}));
}

TEST(StraightRuns, EndWhereALineTurnsBack) {
  EXPECT_EQ(bends({{0, 0}, {2, 0}, {1, 0}, {3, 0}}).size(), 4U);
  EXPECT_EQ(bends({{0, 0}, {2, 0}, {1, 0}}).size(), 3U) << "the far point lies beyond the last";
}

TEST(StraightRuns, CutARing) {
  EXPECT_EQ(bends({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {0, 0}}), (Cuts{0, 2, 3, 4, 6}));
}

TEST(StraightRuns, AreTheSameOfALineInSpace) {
  const std::vector<Vec2> flat = {{0, 0}, {1, 0.01}, {2, -0.01}, {2, 0}, {3, 0}, {3, 1}, {3, 0.5}, {0, 0}};
  std::vector<Vec3> tilted;
  for (const Vec2 p : flat) tilted.push_back({0.6 * p.x, p.y, 0.8 * p.x});
  for (const double tolerance : {1e-9, 0.02, 0.6})
    EXPECT_EQ(find_bends(tilted, tolerance), find_bends(flat, tolerance)) << tolerance;
}

TEST(StraightRuns, OfOneSegmentHaveItsEnds) { EXPECT_EQ(bends({{5, 5}, {6, 6}}), (Cuts{0, 1})); }

}  // namespace
}  // namespace quarry
