#include "kernels/linework/raw_stretch.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace quarry::linework {
namespace {

const std::vector<Vec2> kCorner{{0, 0}, {4, 0}, {4, 4}};

TEST(RawStretch, PointsLieAtTheirParameter) {
  EXPECT_EQ(raw_point(kCorner, 0), (Vec2{0, 0}));
  EXPECT_EQ(raw_point(kCorner, 0.25), (Vec2{1, 0}));
  EXPECT_EQ(raw_point(kCorner, 1), (Vec2{4, 0}));
  EXPECT_EQ(raw_point(kCorner, 2), (Vec2{4, 4}));
}

TEST(RawStretch, NearestParameterStaysWithinTheStretch) {
  EXPECT_DOUBLE_EQ(nearest_parameter(kCorner, 0, 2, {2, 1}), 0.5);
  EXPECT_DOUBLE_EQ(nearest_parameter(kCorner, 0.75, 2, {2, 1}), 0.75);
  EXPECT_DOUBLE_EQ(nearest_parameter(kCorner, 0, 2, {9, 3}), 1.75);
}

TEST(RawStretch, DeviationIsThatOfTheFarthestCorner) {
  EXPECT_DOUBLE_EQ(deviation(kCorner, 0, 2, {0, 0}, {4, 4}), std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(deviation(kCorner, 0, 1, {0, 0}, {4, 0}), 0);
}

TEST(RawStretch, DeviationCountsTheEnds) {
  EXPECT_DOUBLE_EQ(deviation(kCorner, 0, 1, {1, 0}, {4, 0}), 1);
  EXPECT_DOUBLE_EQ(deviation(kCorner, 0.5, 0.75, {0, 0}, {3, 0}), 2);
}

TEST(RawStretch, LengthFollowsTheLine) {
  EXPECT_DOUBLE_EQ(stretch_length(kCorner, 0.5, 1.5), 4);
  EXPECT_DOUBLE_EQ(stretch_length(kCorner, 1, 1), 0);
}

}  // namespace
}  // namespace quarry::linework
