#include "kernels/initial/direction.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/noded_lines.hpp"

namespace quarry {
namespace {

double direction_of(const std::vector<double>& degrees, const std::vector<double>& lengths) {
  test::NodedLinesBuilder builder;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180;
    const Vec2 start{10.0 * static_cast<double>(i), 6.7e6};
    builder.piece(start, start + lengths[i] * Vec2{std::cos(angle), std::sin(angle)});
  }
  return dominant_direction(builder.finish());
}

TEST(DominantDirection, IsThatOfOneLineUpToQuarterTurns) {
  for (const double degrees : {0.0, 10.0, -30.0, 44.0, 100.0, 190.0, -80.0, 359.0}) {
    const double found = direction_of({degrees}, {1});
    EXPECT_NEAR(std::remainder(found - degrees, 90.0), 0, 1e-6);
    EXPECT_GE(found, -45);
    EXPECT_LT(found, 45);
  }
}

TEST(DominantDirection, TakesPerpendicularLinesAsOneDirection) {
  EXPECT_NEAR(direction_of({20, 110}, {1, 3}), 20, 1e-6);
}

TEST(DominantDirection, IsWeightedByLength) {
  const double found = direction_of({0, 30}, {10, 1});
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 5);
}

TEST(DominantDirection, IsHalfARightAngleForLinesAlongTheDiagonals) {
  EXPECT_NEAR(std::abs(direction_of({45}, {1})), 45, 1e-6);
}

TEST(DominantDirection, IsZeroWithoutLinesOrPreference) {
  EXPECT_EQ(dominant_direction(NodedLines()), 0);
  test::NodedLinesBuilder builder;
  builder.piece({0, 0}, {1, 0});
  builder.piece({5, 5}, {5.5, 5.5});
  builder.piece({8, 8}, {8 + 0.7071067811865476 - 0.5, 8 + 0.7071067811865476 - 0.5});
  EXPECT_EQ(dominant_direction(builder.finish()), 0);
}

TEST(DominantDirection, IgnoresAnOutlineThatIsNoInputLine) {
  test::NodedLinesBuilder builder;
  const double angle = 25 * std::numbers::pi / 180;
  builder.piece({0, 0}, {std::cos(angle), std::sin(angle)});
  NodedLines lines = builder.finish();
  lines.nodes.push_back({0, 100});
  lines.pieces.push_back({NodeId(0U), NodeId(2U), PieceKindOf::kOutline});
  lines.line_begin.push_back(lines.line_begin.back());
  EXPECT_NEAR(dominant_direction(lines), 25, 1e-6);
}

}  // namespace
}  // namespace quarry
