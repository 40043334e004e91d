#include "kernels/smooth/shape_star.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

// Four quads or triangles around a vertex near the middle, their corners shaken by the seed.
ShapeStar shaken_star(std::uint64_t seed, double shake, bool triangles, const ShapeTarget& target = {}) {
  const std::array<Vec2, 8> ring = {Vec2{1, 0},  Vec2{1, 1},   Vec2{0, 1},  Vec2{-1, 1},
                                    Vec2{-1, 0}, Vec2{-1, -1}, Vec2{0, -1}, Vec2{1, -1}};
  std::array<Vec2, 8> p;
  for (std::size_t i = 0; i < 8; ++i)
    p[i] = ring[i] + Vec2{shake * (uniform01(seed, 2 * i) - 0.5), shake * (uniform01(seed, 2 * i + 1) - 0.5)};
  ShapeStar star(target);
  for (std::size_t i = 0; i < 8; i += 2) {
    if (triangles && i % 4 == 0)
      star.add_triangle(p[i], p[(i + 2) % 8], 0.9);
    else
      star.add_quad(p[i], p[i + 1], p[(i + 2) % 8], 1.1);
  }
  return star;
}

void expect_derivatives_match(const ShapeStar& star, double regularisation) {
  const Quadratic q = star.expand(regularisation);
  const auto f = [&](double x, double y) { return star.value({x, y}, regularisation); };
  EXPECT_DOUBLE_EQ(q.value, f(0, 0));
  constexpr double kStep = 1e-4;
  const double scale = 1e-6 * (1 + std::abs(q.xx) + std::abs(q.yy) + length(q.gradient));
  EXPECT_NEAR(q.gradient.x, (f(kStep, 0) - f(-kStep, 0)) / (2 * kStep), 10 * scale);
  EXPECT_NEAR(q.gradient.y, (f(0, kStep) - f(0, -kStep)) / (2 * kStep), 10 * scale);
  EXPECT_NEAR(q.xx, (f(kStep, 0) - 2 * f(0, 0) + f(-kStep, 0)) / (kStep * kStep), 100 * scale);
  EXPECT_NEAR(q.yy, (f(0, kStep) - 2 * f(0, 0) + f(0, -kStep)) / (kStep * kStep), 100 * scale);
  EXPECT_NEAR(
      q.xy, (f(kStep, kStep) - f(-kStep, kStep) - f(kStep, -kStep) + f(-kStep, -kStep)) / (4 * kStep * kStep),
      100 * scale);
}

TEST(ShapeStar, HasTheDerivativesThatDifferencesShow) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    expect_derivatives_match(shaken_star(seed, 0.7, seed % 2 == 0), 0);
    // Shaken this much, corners are turned over.
    expect_derivatives_match(shaken_star(seed, 3, seed % 2 == 0), 0.5);
  }
}

TEST(ShapeStar, IsInfiniteWhereACornerIsFlatOrTurnedOver) {
  const ShapeStar star = shaken_star(1, 0, false);
  EXPECT_TRUE(std::isfinite(star.value({0.9, 0}, 0)));
  EXPECT_TRUE(std::isinf(star.value({1, 0}, 0)));
  EXPECT_TRUE(std::isinf(star.value({1.1, 0}, 0)));
  EXPECT_TRUE(std::isfinite(star.value({1.1, 0}, 0.1)));
}

TEST(ShapeStar, FollowsTheAspectsOfCornersDownToTheSlopesOfTheirSines) {
  // 2 / sine for each corner that moves.
  const ShapeTarget target{.stretch = Stretch::kOfCorner, .size_weight = 0, .largest_aspect = 100};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    ShapeStar star = shaken_star(seed, 0.7, false, target);
    star.follow_stretch();
    const Quadratic q = star.expand(0);
    EXPECT_DOUBLE_EQ(q.value, star.value({}, 0));
    constexpr double kStep = 1e-5;
    const double scale = 1e-6 * (1 + length(q.gradient));
    EXPECT_NEAR(q.gradient.x, (star.value({kStep, 0}, 0) - star.value({-kStep, 0}, 0)) / (2 * kStep), scale);
    EXPECT_NEAR(q.gradient.y, (star.value({0, kStep}, 0) - star.value({0, -kStep}, 0)) / (2 * kStep), scale);
    EXPECT_GE(q.value, 24);
  }
}

TEST(ShapeStar, ReachesTheMinimumOfAValidStarByNewtonStepsAlone) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    // With ratios frozen the energy is convex: from the minimum no direction goes down.
    const ShapeStar star = shaken_star(seed, 0.7, false);
    const Vec2 step = star.expand(0).step();
    EXPECT_LT(star.value(0.25 * step, 0), star.value({}, 0));
    const Quadratic q = star.expand(0);
    EXPECT_GT(q.xx * q.yy - q.xy * q.xy, 0);
    EXPECT_GT(q.xx + q.yy, 0);
  }
}

TEST(ShapeStar, HoldsARectangleAsGoodAsASquareUpToTheLargestAspect) {
  const auto slope = [](double aspect) {
    ShapeStar star({.size_weight = 0});
    star.add_quad({aspect, 0}, {aspect, 1}, {0, 1}, aspect);
    star.follow_stretch();
    return length(star.expand(0).gradient);
  };
  const double limit = ShapeTarget().largest_aspect;
  EXPECT_NEAR(slope(1), 0, 1e-12);
  EXPECT_NEAR(slope(0.99 * limit), 0, 1e-12);
  EXPECT_NEAR(slope(1.01 / limit), 0, 1e-12);
  EXPECT_GT(slope(1.1 * limit), 0.1);
}

TEST(Quadratic, StepsDownhillWhateverTheCurvature) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto draw = [&](std::uint64_t i) { return 2 * uniform01(seed, i) - 1; };
    Quadratic q;
    q.gradient = {draw(0), draw(1)};
    q.xx = draw(2);
    q.yy = draw(3);
    q.xy = draw(4);
    EXPECT_LT(dot(q.step(), q.gradient), 0);
    EXPECT_LT(dot(q.step_along({0.6, 0.8}), q.gradient), 0);
  }
}

TEST(Quadratic, StepsToTheMinimumOfABowl) {
  Quadratic q;
  q.gradient = {-4, -6};
  q.xx = 2;
  q.yy = 3;
  EXPECT_DOUBLE_EQ(q.step().x, 2);
  EXPECT_DOUBLE_EQ(q.step().y, 2);
}

}  // namespace
}  // namespace quarry
