#include "kernels/cleanup/irregular_price.hpp"

#include <gtest/gtest.h>

namespace quarry {
namespace {

constexpr Vec2 kFar{6.7e6, 3.1e5};

Vec3 at(double x, double y) { return {kFar.x + x, kFar.y + y, 0}; }

TEST(PriceNear, IsTheFactorUpToTheDistanceAndOneAtTwiceThat) {
  const IrregularPrice price = price_near({{kFar, kFar + Vec2{10, 0}}}, {.distance = 2, .factor = 5});
  for (const double y : {0.0, 1.0, -1.99}) EXPECT_EQ(price(at(5, y)), 5.0) << y;
  EXPECT_EQ(price(at(-1.5, 1)), 5.0) << "ends are round";
  for (const double y : {4.01, 100.0, -1e6}) EXPECT_EQ(price(at(5, y)), 1.0) << y;
  EXPECT_NEAR(price(at(5, 3)), 3.0, 1e-6) << "half way";
}

TEST(PriceNear, FallsSmoothly) {
  const IrregularPrice price = price_near({{kFar, kFar + Vec2{10, 0}}}, {.distance = 2, .factor = 5});
  double last = 5;
  for (int i = 0; i <= 100; ++i) {
    const double now = price(at(3, 2 + 0.02 * i));
    EXPECT_LE(now, last);
    EXPECT_LE(last - now, 4 * 1.5 * 0.0101) << "no step is steeper than the middle";
    last = now;
  }
}

TEST(PriceNear, LooksAtTheNearestSegment) {
  std::vector<Segment> segments;
  for (int i = 0; i < 50; ++i) segments.push_back({{10.0 * i, 0}, {10.0 * i, 100}});
  const IrregularPrice price = price_near(std::move(segments), {.distance = 1, .factor = 0.25});
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(price({10.0 * i + 0.5, 50, 0}), 0.25);
    EXPECT_EQ(price({10.0 * i + 5, 50, 0}), 1);
  }
}

TEST(PriceNear, OfNoSegmentsIsNone) { EXPECT_FALSE(price_near({}, {.distance = 1, .factor = 2})); }

}  // namespace
}  // namespace quarry
