#include "surface/project/triangle_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "tests/surface/project/surface_samples.hpp"

namespace quarry {
namespace {

using test::Draws;
using test::kSeed;

double squared(Vec3 v) { return dot(v, v); }

// Nothing is nearer: no point of a triangle lies in front of the plane through the nearest one, across the
// way to it. For a convex set that is both needed and enough.
double farthest_in_front(Vec3 p, Vec3 nearest, const TriangleCorners& corners) {
  double worst = 0;
  for (const Vec3 corner : corners) worst = std::max(worst, dot(p - nearest, corner - nearest));
  return worst;
}

double size_of(const TriangleCorners& t) {
  return std::max({length(t[1] - t[0]), length(t[2] - t[0]), length(t[2] - t[1])});
}

TEST(ClosestOnTriangle, HasNoPointOfTheTriangleInFrontOfIt) {
  Draws draws(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    const TriangleCorners corners{draws.in_cube(1), draws.in_cube(1), draws.in_cube(1)};
    const Vec3 p = draws.in_cube(std::exp(draws.uniform(-3, 6)));
    const TrianglePoint<double> point = closest_on_triangle(p, corners);
    const Vec3 nearest = point_at(point.weights, corners);
    const double distance = length(p - nearest);
    ASSERT_LE(farthest_in_front(p, nearest, corners), 1e-11 * (1 + distance)) << "case " << i;
    ASSERT_NEAR(std::sqrt(point.squared_distance), distance, 1e-13 * (1 + distance)) << "case " << i;
    for (const double weight : point.weights) ASSERT_GE(weight, 0);
    ASSERT_NEAR(point.weights[0] + point.weights[1] + point.weights[2], 1, 1e-15);
  }
}

// No sample of a triangle with coordinates of about 1 is nearer, by more than rounding.
void expect_no_sample_nearer(Vec3 p, const TriangleCorners& corners) {
  const TrianglePoint<double> point = closest_on_triangle(p, corners);
  ASSERT_TRUE(std::isfinite(point.squared_distance));
  constexpr int kSteps = 40;
  double nearest = point.squared_distance;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j)
      nearest = std::min(nearest, squared(p - (corners[0] + (1.0 * i / kSteps) * (corners[1] - corners[0]) +
                                               (1.0 * j / kSteps) * (corners[2] - corners[0]))));
  ASSERT_GE(std::sqrt(nearest), std::sqrt(point.squared_distance) - 2e-15);
  const Vec3 position = point_at(point.weights, corners);
  ASSERT_NEAR(length(p - position), std::sqrt(point.squared_distance),
              1e-13 * (size_of(corners) + length(p)));
}

TEST(ClosestOnTriangle, TakesTrianglesWithoutArea) {
  Draws draws(kSeed);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = draws.in_cube(1), b = draws.in_cube(1), p = draws.in_cube(2);
    const Vec3 between = a + draws.uniform(-0.5, 1.5) * (b - a);
    const Vec3 off = between + draws.in_cube(std::exp(draws.uniform(-40, 0)));
    for (const Vec3 from : {p, a, between, off}) {
      expect_no_sample_nearer(from, {a, a, a});
      expect_no_sample_nearer(from, {a, a, b});
      expect_no_sample_nearer(from, {a, b, a});
      expect_no_sample_nearer(from, {b, a, a});
      expect_no_sample_nearer(from, {a, b, between});
      expect_no_sample_nearer(from, {between, a, b});
      expect_no_sample_nearer(from, {a, b, off});
    }
  }
}

TEST(ClosestOnTriangle, IsExactlyTheCornerWhereThatIsNearest) {
  Draws draws(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 offset{6.7e6, -5e5, 1234.5};
    const TriangleCorners corners{offset + draws.in_cube(1), offset + draws.in_cube(1),
                                  offset + draws.in_cube(1)};
    for (const Vec3 corner : corners) {
      const TrianglePoint<double> point = closest_on_triangle(corner, corners);
      ASSERT_EQ(point.squared_distance, 0);
      ASSERT_EQ(point_at(point.weights, corners), corner);
    }
  }
}

TEST(ClosestOnTriangle, HasTheSameBitsOnBothSidesOfAnEdge) {
  Draws draws(kSeed);
  int ties = 0;
  for (int i = 0; i < 2000; ++i) {
    // A roof, seen from above its ridge: both slopes have their nearest point there.
    const Vec3 a{-1, 0, 0}, b{1, draws.uniform(-0.1, 0.1), draws.uniform(-0.1, 0.1)};
    const Vec3 left{draws.uniform(-0.5, 0.5), -1, -2}, right{draws.uniform(-0.5, 0.5), 1, -2};
    const Vec3 p{draws.uniform(-0.9, 0.9), 0, 1};
    // Corners ascending, as the tree gives them.
    const TrianglePoint<double> on_left = closest_on_triangle(p, {a, left, b});
    const TrianglePoint<double> on_right = closest_on_triangle(p, {a, right, b});
    ASSERT_EQ(on_left.squared_distance, on_right.squared_distance) << "case " << i;
    ties += on_left.weights[1] == 0 && on_left.weights[0] > 0 && on_left.weights[2] > 0 ? 1 : 0;
  }
  EXPECT_GT(ties, 1900);
}

TEST(ClosestOnTriangle, HasTheSameBitsInALaneAsAlone) {
  Draws draws(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = draws.in_cube(2), a = draws.in_cube(1), b = draws.in_cube(1);
    const std::array<Vec3, 3> c{draws.in_cube(1), a + draws.uniform(-1, 2) * (b - a), a};
    TriangleBlock block;
    std::array<OrderedTriangle, 2> triangles;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const std::array<Vec3, 3> points{a, b, c[(static_cast<std::size_t>(i) + lane) % 3]};
      triangles[lane] = OrderedTriangle(points, {0, 1, 2});
      block.set(lane, TriangleId(lane), triangles[lane]);
    }
    for (const Vec3 from : {p, a, 0.5 * (a + b)}) {
      const Double2 squared = block.squared_distances(from);
      for (std::size_t lane = 0; lane < 2; ++lane)
        ASSERT_EQ(squared[lane], closest_on_triangle(from, triangles[lane].corners).squared_distance) << i;
    }
  }
}

}  // namespace
}  // namespace quarry
