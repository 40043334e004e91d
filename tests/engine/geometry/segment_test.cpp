#include "engine/geometry/segment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

Vec2 random_point(std::uint64_t counter, Vec2 origin = {}, double size = 1) {
  return origin + size * Vec2{uniform01(5, 2 * counter), uniform01(5, 2 * counter + 1)};
}

TEST(ClosestPoint, IsTheFootInsideAndAnEndOutside) {
  EXPECT_EQ(closest_point({1, 5}, {0, 0}, {4, 0}), (Vec2{1, 0}));
  EXPECT_EQ(closest_point({-3, 1}, {0, 0}, {4, 0}), (Vec2{0, 0}));
  EXPECT_EQ(closest_point({9, 1}, {0, 0}, {4, 0}), (Vec2{4, 0}));
  EXPECT_EQ(closest_point({9, 1}, {2, 2}, {2, 2}), (Vec2{2, 2}));
  EXPECT_EQ(projection_parameter({-4, 1}, {0, 0}, {4, 0}), -1);
}

TEST(PointAt, KeepsTheBitsOfBothEnds) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec2 a = random_point(2 * i, {6.7e6, 0});
    const Vec2 b = random_point(2 * i + 1);
    ASSERT_EQ(point_at(0, a, b), a);
    ASSERT_EQ(point_at(1, a, b), b);
  }
}

TEST(SquaredDistance, IsTheLeastOverTheSegment) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vec2 a = random_point(3 * i);
    const Vec2 b = random_point(3 * i + 1);
    const Vec2 p = random_point(3 * i + 2, {-0.5, -0.5}, 2);
    double least = squared_length(p - a);
    for (int k = 0; k <= 1000; ++k) least = std::min(least, squared_length(p - point_at(k / 1000.0, a, b)));
    ASSERT_LE(squared_distance(p, a, b), least + 1e-12);
    ASSERT_NEAR(squared_distance(p, a, b), least, 1e-5);
    ASSERT_NEAR(squared_distance(p, a, b), squared_length(p - closest_point(p, a, b)), 1e-14);
  }
}

TEST(SquaredDistance, KeepsItsDigitsAtMapCoordinates) {
  const Vec2 a{6'700'000, 300'000};
  const Vec2 b{6'700'300, 300'100};
  const Vec2 p = midpoint(a, b) + Vec2{0, 0x1p-20};
  const double expected = 0x1p-20 * 300 / std::sqrt(300.0 * 300 + 100 * 100);
  EXPECT_NEAR(std::sqrt(squared_distance(p, a, b)), expected, 1e-13);
}

void expect_meeting(Meeting expected, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  for (const bool flip_first : {false, true}) {
    for (const bool flip_second : {false, true}) {
      if (flip_first) std::swap(a, b);
      if (flip_second) std::swap(c, d);
      EXPECT_EQ(meeting(a, b, c, d), expected);
      EXPECT_EQ(meeting(c, d, a, b), expected);
    }
  }
}

TEST(SegmentMeeting, TellsProperCrossingsFromTouches) {
  expect_meeting(Meeting::kProper, {0, 0}, {2, 2}, {0, 2}, {2, 0});
  expect_meeting(Meeting::kTouch, {0, 0}, {2, 2}, {1, 1}, {2, 0});
  expect_meeting(Meeting::kTouch, {0, 0}, {2, 2}, {2, 2}, {3, 0});
  expect_meeting(Meeting::kApart, {0, 0}, {2, 2}, {3, 3.5}, {4, 0});
  expect_meeting(Meeting::kApart, {0, 0}, {2, 2}, {0, 1}, {2, 3});
}

TEST(SegmentMeeting, TellsOverlapsOnOneLine) {
  expect_meeting(Meeting::kOverlap, {0, 0}, {2, 2}, {1, 1}, {3, 3});
  expect_meeting(Meeting::kOverlap, {0, 0}, {0, 4}, {0, 1}, {0, 2});
  expect_meeting(Meeting::kOverlap, {0, 0}, {2, 2}, {0, 0}, {2, 2});
  expect_meeting(Meeting::kTouch, {0, 0}, {2, 2}, {2, 2}, {3, 3});
  expect_meeting(Meeting::kApart, {0, 0}, {2, 2}, {3, 3}, {4, 4});
}

TEST(SegmentMeeting, TakesSegmentsOfNoLengthAsPoints) {
  expect_meeting(Meeting::kTouch, {1, 1}, {1, 1}, {0, 0}, {2, 2});
  expect_meeting(Meeting::kTouch, {1, 1}, {1, 1}, {1, 1}, {1, 1});
  expect_meeting(Meeting::kApart, {1, 1.5}, {1, 1.5}, {0, 0}, {2, 2});
  expect_meeting(Meeting::kApart, {3, 3}, {3, 3}, {0, 0}, {2, 2});
}

TEST(SegmentMeeting, IsExactOneRoundingFromATouch) {
  const Vec2 a{6'700'000, 300'000};
  const Vec2 b{6'700'003, 300'001};
  const Vec2 on{6'700'001.5, 300'000.5};
  const Vec2 above{on.x, std::nextafter(on.y, 1e9)};
  const Vec2 below{on.x, std::nextafter(on.y, -1e9)};
  const Vec2 far{6'700'001, 300'009};
  expect_meeting(Meeting::kTouch, a, b, on, far);
  expect_meeting(Meeting::kApart, a, b, above, far);
  expect_meeting(Meeting::kProper, a, b, below, far);
  EXPECT_TRUE(on_segment(on, a, b));
  EXPECT_FALSE(on_segment(above, a, b));
  EXPECT_TRUE(on_segment(b, a, b));
}

TEST(CrossingPoint, HasTheSameBitsForAnyOrder) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec2 origin{6.7e6, 3e5};
    const Vec2 a = random_point(4 * i, origin), b = random_point(4 * i + 1, origin);
    const Vec2 c = random_point(4 * i + 2, origin), d = random_point(4 * i + 3, origin);
    const Vec2 point = crossing_point(a, b, c, d);
    ASSERT_EQ(crossing_point(b, a, c, d), point);
    ASSERT_EQ(crossing_point(c, d, a, b), point);
    ASSERT_EQ(crossing_point(d, c, b, a), point);
  }
}

TEST(CrossingPoint, LiesOnBothSegmentsUpToRoundingHoweverFlatTheyCross) {
  const Vec2 origin{6.7e6, 3e5};
  const double rounding = 6.7e6 * 0x1p-52;
  int crossings = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const Vec2 a = random_point(4 * i, origin, 100);
    const Vec2 b = random_point(4 * i + 1, origin, 100);
    // The second segment leaves the first by ever less, down to a few roundings.
    const double opening = std::ldexp(100, -static_cast<int>(i % 40));
    const Vec2 c = a + opening * random_point(4 * i + 2, {-0.5, -0.5});
    const Vec2 d = b + opening * random_point(4 * i + 3, {-0.5, -0.5});
    if (meeting(a, b, c, d) != Meeting::kProper) continue;
    ++crossings;
    const Vec2 point = crossing_point(a, b, c, d);
    ASSERT_LE(std::sqrt(squared_distance(point, a, b)), 4 * rounding) << "case " << i;
    ASSERT_LE(std::sqrt(squared_distance(point, c, d)), 4 * rounding) << "case " << i;
  }
  EXPECT_GT(crossings, 2000);
}

TEST(SignedAngle, KeepsItsDigitsNearZeroAndPi) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(signed_angle({1, 0}, {1, 1e-12}), 1e-12, 1e-27);
  EXPECT_NEAR(signed_angle({1, 0}, {1, -1e-12}), -1e-12, 1e-27);
  EXPECT_NEAR(signed_angle({1, 0}, {0, 3}), kPi / 2, 1e-15);
  EXPECT_NEAR(signed_angle({2, 0}, {-1, 1e-12}), kPi - 1e-12, 1e-15);
  EXPECT_EQ(signed_angle({0, 0}, {1, 1}), 0);
}

TEST(CounterclockwiseAngle, StaysBelowAFullTurn) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(counterclockwise_angle({1, 0}, {0, -2}), 1.5 * kPi, 1e-15);
  EXPECT_EQ(counterclockwise_angle({1, 0}, {1, 0}), 0);
  EXPECT_LT(counterclockwise_angle({1, 0}, {1, -1e-300}), 2 * kPi);
  EXPECT_GE(counterclockwise_angle({1, 0}, {1, -1e-300}), 0);
}

}  // namespace
}  // namespace quarry
