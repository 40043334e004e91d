#include "engine/geometry/predicates.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

// On integer coordinates that fit, 128-bit integers tell the truth without any other library.
using Wide = __int128;

template <class Number>
int sign(Number value) {
  return (value > 0) - (value < 0);
}

Wide wide(double value) { return static_cast<Wide>(value); }

int true_orient2d(Vec2 a, Vec2 b, Vec2 c) {
  return sign((wide(a.x) - wide(c.x)) * (wide(b.y) - wide(c.y)) -
              (wide(a.y) - wide(c.y)) * (wide(b.x) - wide(c.x)));
}

int true_incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto minor = [&](Vec2 p, Vec2 q) {
    return (wide(p.x) - wide(d.x)) * (wide(q.y) - wide(d.y)) -
           (wide(p.y) - wide(d.y)) * (wide(q.x) - wide(d.x));
  };
  const auto lift = [&](Vec2 p) {
    return (wide(p.x) - wide(d.x)) * (wide(p.x) - wide(d.x)) +
           (wide(p.y) - wide(d.y)) * (wide(p.y) - wide(d.y));
  };
  return sign(lift(a) * minor(b, c) + lift(b) * minor(c, a) + lift(c) * minor(a, b));
}

int true_orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const auto minor = [&](Vec3 p, Vec3 q) {
    return (wide(p.x) - wide(d.x)) * (wide(q.y) - wide(d.y)) -
           (wide(p.y) - wide(d.y)) * (wide(q.x) - wide(d.x));
  };
  return sign((wide(a.z) - wide(d.z)) * minor(b, c) + (wide(b.z) - wide(d.z)) * minor(c, a) +
              (wide(c.z) - wide(d.z)) * minor(a, b));
}

constexpr std::uint64_t kSeed = 20240607;

double integer(std::uint64_t counter, double limit) {
  return std::floor((2 * uniform01(kSeed, counter) - 1) * limit);
}

TEST(Orient2d, IsPositiveForALeftTurn) {
  EXPECT_GT(orient2d({0, 0}, {1, 0}, {0, 1}), 0);
  EXPECT_LT(orient2d({0, 0}, {0, 1}, {1, 0}), 0);
  EXPECT_NEAR(orient2d({0, 0}, {3, 0}, {0, 5}), 15, 1e-12);
}

TEST(Orient2d, IsRightOnIntegersThatNearlyLieOnALine) {
  int zeros = 0;
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    const double limit = std::ldexp(1, 3 + static_cast<int>(i % 51));
    const Vec2 a{integer(5 * i, limit), integer(5 * i + 1, limit)};
    const Vec2 b{integer(5 * i + 2, limit), integer(5 * i + 3, limit)};
    const double t = uniform01(kSeed, 5 * i + 4);
    const Vec2 c{std::round(a.x + t * (b.x - a.x)), std::round(a.y + t * (b.y - a.y))};
    ASSERT_EQ(sign(orient2d(a, b, c)), true_orient2d(a, b, c)) << "case " << i << " of seed " << kSeed;
    zeros += true_orient2d(a, b, c) == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 100);
}

TEST(Orient2d, ChangesItsSignWithEachExchangeOfPoints) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const Vec2 a{uniform01(1, 4 * i), uniform01(1, 4 * i + 1)};
    const Vec2 b{uniform01(1, 4 * i + 2), uniform01(1, 4 * i + 3)};
    const Vec2 c = midpoint(a, b);
    const int turn = sign(orient2d(a, b, c));
    ASSERT_EQ(sign(orient2d(b, c, a)), turn);
    ASSERT_EQ(sign(orient2d(c, a, b)), turn);
    ASSERT_EQ(sign(orient2d(b, a, c)), -turn);
    ASSERT_EQ(sign(orient2d(a, c, b)), -turn);
    ASSERT_EQ(sign(orient2d(c, b, a)), -turn);
  }
}

TEST(Orient2d, SeesOneRoundingAtMapCoordinates) {
  const Vec2 a{6'700'000, 300'000};
  const Vec2 b{6'700'003, 300'001};
  const Vec2 on_line{6'700'001.5, 300'000.5};
  EXPECT_EQ(orient2d(a, b, on_line), 0);
  const Vec2 left{on_line.x, std::nextafter(on_line.y, 1e9)};
  const Vec2 right{std::nextafter(on_line.x, 1e9), on_line.y};
  EXPECT_GT(orient2d(a, b, left), 0);
  EXPECT_LT(orient2d(a, b, right), 0);
}

TEST(Orient2d, IsZeroForRepeatedPoints) {
  const Vec2 a{6'700'000.1, 0.3};
  const Vec2 b{-1e-9, 1.0 / 3};
  EXPECT_EQ(orient2d(a, a, b), 0);
  EXPECT_EQ(orient2d(a, b, a), 0);
  EXPECT_EQ(orient2d(b, a, a), 0);
  EXPECT_EQ(orient2d(a, a, a), 0);
}

TEST(Orient3d, IsPositiveBelowAPlaneSeenTurningLeft) {
  EXPECT_GT(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}), 0);
  EXPECT_LT(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}), 0);
  EXPECT_EQ(orient3d({0.1, 0.1, 0.1}, {0.7, 0.1, 0.1}, {0.3, 0.9, 0.1}, {1.0 / 3, 1.0 / 7, 0.1}), 0);
}

TEST(Orient3d, IsRightOnIntegersThatNearlyLieOnAPlane) {
  int zeros = 0;
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    const double limit = std::ldexp(1, 2 + static_cast<int>(i % 36));
    Vec3 p[3];
    for (std::uint64_t k = 0; k < 3; ++k)
      p[k] = {integer(11 * i + 3 * k, limit), integer(11 * i + 3 * k + 1, limit),
              integer(11 * i + 3 * k + 2, limit)};
    const Vec3 d =
        p[0] + uniform01(kSeed, 11 * i + 9) * (p[1] - p[0]) + uniform01(kSeed, 11 * i + 10) * (p[2] - p[0]);
    const Vec3 near{std::round(d.x), std::round(d.y), std::round(d.z)};
    const int truth = true_orient3d(p[0], p[1], p[2], near);
    ASSERT_EQ(sign(orient3d(p[0], p[1], p[2], near)), truth) << "case " << i << " of seed " << kSeed;
    ASSERT_EQ(sign(orient3d(p[1], p[0], p[2], near)), -truth) << "case " << i << " of seed " << kSeed;
    zeros += truth == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 100);
}

TEST(Incircle, IsPositiveInsideACircleThroughALeftTurn) {
  EXPECT_GT(incircle({1, 0}, {0, 1}, {-1, 0}, {0, 0}), 0);
  EXPECT_LT(incircle({1, 0}, {0, 1}, {-1, 0}, {0, -2}), 0);
  EXPECT_LT(incircle({-1, 0}, {0, 1}, {1, 0}, {0, 0}), 0) << "a right turn changes the sign";
}

TEST(Incircle, IsRightOnIntegersThatNearlyLieOnACircle) {
  int zeros = 0;
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    const double radius = std::ldexp(1, 2 + static_cast<int>(i % 23));
    Vec2 p[4];
    for (std::uint64_t k = 0; k < 4; ++k) {
      const double angle = 6.3 * uniform01(kSeed, 4 * i + k);
      p[k] = {std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))};
    }
    const int truth = true_incircle(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(sign(incircle(p[0], p[1], p[2], p[3])), truth) << "case " << i << " of seed " << kSeed;
    zeros += truth == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 100);
}

TEST(Incircle, IsZeroForSquaresAndPythagoreanPointsAtMapCoordinates) {
  const Vec2 centre{6'700'000, 300'000.5};
  const auto at = [&](double x, double y) { return centre + Vec2{x, y}; };
  EXPECT_EQ(incircle(at(3, 4), at(-4, 3), at(-5, 0), at(0, -5)), 0);
  EXPECT_GT(incircle(at(3, 4), at(-4, 3), at(-5, 0), at(0, -5 + 1e-9)), 0);
  EXPECT_LT(incircle(at(3, 4), at(-4, 3), at(-5, 0), at(0, -5 - 1e-9)), 0);
}

TEST(Incircle, IsZeroForRepeatedPoints) {
  const Vec2 a{6'700'000.1, 0.3};
  const Vec2 b{-1e-9, 1.0 / 3};
  const Vec2 c{0.1, 7.7};
  EXPECT_EQ(incircle(a, b, c, c), 0);
  EXPECT_EQ(incircle(a, b, a, c), 0);
  EXPECT_EQ(incircle(b, b, a, c), 0);
}

}  // namespace
}  // namespace quarry
