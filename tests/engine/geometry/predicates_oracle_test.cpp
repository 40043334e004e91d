// The predicates against CGAL's kernel on exact numbers, on the kinds of input that decide badly.
#include <gtest/gtest.h>

#ifdef QUARRY_HAVE_CGAL

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"

namespace quarry {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::MP_Float>;

constexpr std::uint64_t kSeed = 7;
constexpr int kCases = 20'000;

class Draws {
 public:
  double uniform() { return uniform01(kSeed, counter_++); }
  double integer_below(int limit) { return std::floor(uniform() * limit); }
  // One of the value and its two neighbours among the doubles.
  double nudged(double value) {
    const double which = integer_below(3);
    return which == 0 ? value : std::nextafter(value, which == 1 ? -1e9 : 1e9);
  }

 private:
  std::uint64_t counter_ = 0;
};

template <class Point>
using Four = std::array<Point, 4>;

int sign(double value) { return (value > 0) - (value < 0); }

Kernel::Point_2 exact(Vec2 p) { return {p.x, p.y}; }
Kernel::Point_3 exact(Vec3 p) { return {p.x, p.y, p.z}; }

template <class Draw>
void expect_signs_of_cgal_2d(Draw&& draw) {
  Draws draws;
  for (int i = 0; i < kCases; ++i) {
    const Four<Vec2> p = draw(draws);
    const auto a = exact(p[0]), b = exact(p[1]), c = exact(p[2]), d = exact(p[3]);
    const int turn = CGAL::orientation(a, b, c);
    ASSERT_EQ(sign(orient2d(p[0], p[1], p[2])), turn) << "orient2d, case " << i << " of seed " << kSeed;
    if (turn == 0) continue;
    // CGAL's circle has its inside to its left, as ours.
    ASSERT_EQ(sign(incircle(p[0], p[1], p[2], p[3])),
              static_cast<int>(CGAL::side_of_oriented_circle(a, b, c, d)))
        << "incircle, case " << i << " of seed " << kSeed;
  }
}

template <class Draw>
void expect_signs_of_cgal_3d(Draw&& draw) {
  Draws draws;
  for (int i = 0; i < kCases; ++i) {
    const Four<Vec3> p = draw(draws);
    // CGAL is positive above the plane.
    const int above = CGAL::orientation(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
    ASSERT_EQ(sign(orient3d(p[0], p[1], p[2], p[3])), -above) << "case " << i << " of seed " << kSeed;
  }
}

template <class Point, class One>
Four<Point> each(One&& one) {
  Four<Point> points;
  for (Point& point : points) point = one();
  return points;
}

TEST(PredicatesAgainstCgal, AgreeOnRandomPoints) {
  expect_signs_of_cgal_2d([](Draws& r) {
    return each<Vec2>([&] { return Vec2{r.uniform(), r.uniform()}; });
  });
  expect_signs_of_cgal_3d([](Draws& r) {
    return each<Vec3>([&] { return Vec3{r.uniform(), r.uniform(), r.uniform()}; });
  });
}

TEST(PredicatesAgainstCgal, AgreeOnAnIntegerLattice) {
  expect_signs_of_cgal_2d([](Draws& r) {
    return each<Vec2>([&] { return Vec2{r.integer_below(8), r.integer_below(8)}; });
  });
  expect_signs_of_cgal_3d([](Draws& r) {
    return each<Vec3>([&] { return Vec3{r.integer_below(4), r.integer_below(4), r.integer_below(4)}; });
  });
}

TEST(PredicatesAgainstCgal, AgreeOnAGridOfMapCoordinates) {
  expect_signs_of_cgal_2d([](Draws& r) {
    return each<Vec2>([&] { return Vec2{6.7e6 + 0.1 * r.integer_below(8), 3e5 + 0.1 * r.integer_below(8)}; });
  });
  expect_signs_of_cgal_3d([](Draws& r) {
    return each<Vec3>([&] {
      return Vec3{6.7e6 + 0.1 * r.integer_below(4), 3e5 + 0.1 * r.integer_below(4), 0.1 * r.integer_below(4)};
    });
  });
}

TEST(PredicatesAgainstCgal, AgreeOnPointsOnALineOrPlaneUpToRounding) {
  for (const Vec2 origin : {Vec2{0, 0}, Vec2{0.3, 0.7}, Vec2{6.7e6, 3e5}}) {
    expect_signs_of_cgal_2d([&](Draws& r) {
      const Vec2 along{r.uniform(), r.uniform()};
      return each<Vec2>([&] { return origin + r.uniform() * along; });
    });
    expect_signs_of_cgal_3d([&](Draws& r) {
      const Vec2 slope{r.uniform(), r.uniform()};
      return each<Vec3>([&] {
        const Vec2 foot{r.uniform(), r.uniform()};
        return Vec3{origin.x + foot.x, origin.y + foot.y, dot(slope, foot)};
      });
    });
  }
}

TEST(PredicatesAgainstCgal, AgreeOnPointsOnACircleUpToRounding) {
  for (const Vec2 centre : {Vec2{0, 0}, Vec2{0.5, 0.5}, Vec2{6.7e6, 3e5}}) {
    expect_signs_of_cgal_2d([&](Draws& r) {
      const double radius = 50 * r.uniform();
      return each<Vec2>([&] {
        const double angle = 6.3 * r.uniform();
        return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
      });
    });
  }
}

TEST(PredicatesAgainstCgal, AgreeOnALatticeThatRoundingHasNudged) {
  // From 1 on: the neighbours of zero are so small that their products underflow.
  expect_signs_of_cgal_2d([](Draws& r) {
    const auto one = [&] { return r.nudged(0.1 * (1 + r.integer_below(8))); };
    return each<Vec2>([&] { return Vec2{one(), one()}; });
  });
  expect_signs_of_cgal_3d([](Draws& r) {
    const auto one = [&] { return r.nudged(0.1 * (1 + r.integer_below(4))); };
    return each<Vec3>([&] { return Vec3{one(), one(), one()}; });
  });
}

TEST(PredicatesAgainstCgal, AgreeOnCoordinatesOfVeryDifferentSize) {
  const auto one = [](Draws& r) {
    return std::ldexp(r.uniform() - 0.5, static_cast<int>(r.integer_below(60)) - 30);
  };
  expect_signs_of_cgal_2d([&](Draws& r) { return each<Vec2>([&] { return Vec2{one(r), one(r)}; }); });
  expect_signs_of_cgal_2d([&](Draws& r) {
    Four<Vec2> p = each<Vec2>([&] { return Vec2{one(r), one(r)}; });
    p[2] = midpoint(p[0], p[1]);
    p[3] = midpoint(p[0], p[2]);
    return p;
  });
  expect_signs_of_cgal_3d([&](Draws& r) { return each<Vec3>([&] { return Vec3{one(r), one(r), one(r)}; }); });
}

}  // namespace
}  // namespace quarry

#else

TEST(PredicatesAgainstCgal, AgreeOnEveryKindOfInput) {
  GTEST_SKIP() << "CGAL's headers (libcgal-dev) were not found when the build was configured";
}

#endif
