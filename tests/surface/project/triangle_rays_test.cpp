// Rays and inside tests, above all where a ray meets edges and corners.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "surface/project/ray_crossing.hpp"
#include "surface/project/triangle_tree.hpp"
#include "tests/surface/project/surface_samples.hpp"

namespace quarry {
namespace {

using namespace test;

std::uint32_t sum(const CrossingCounts& counts) { return counts.from_front + counts.from_back; }

// Points that rays through edges and corners go through.
std::vector<Vec3> corners_and_edges(const Surface& surface) {
  std::vector<Vec3> aims = surface.points;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = surface.points[t[i]], b = surface.points[t[(i + 1) % 3]];
      aims.push_back(a + 0.5 * (b - a));
      aims.push_back(a + 0.3 * (b - a));
    }
  return aims;
}

// Every ray from inside a closed surface gets out, and crosses an odd number of times.
void expect_no_way_out(const Surface& surface, Vec3 inside) {
  const TriangleTree tree(surface.points, surface.triangles);
  ASSERT_TRUE(tree.encloses(inside));
  for (const Vec3 aim : corners_and_edges(surface)) {
    const SurfaceHit hit = tree.ray(inside, aim - inside);
    ASSERT_TRUE(hit.triangle.valid()) << "towards " << aim.x << " " << aim.y << " " << aim.z;
    ASSERT_LE(hit.parameter, 1 + 1e-15 * (1 + length(inside)));
    const CrossingCounts counts = tree.crossings(inside, aim - inside);
    ASSERT_EQ(counts.from_back, counts.from_front + 1) << "towards " << aim.x << " " << aim.y << " " << aim.z;
  }
}

// Every ray from outside through an edge or a corner hits, and crosses an even number of times.
void expect_met_from(const Surface& surface, Vec3 outside) {
  const TriangleTree tree(surface.points, surface.triangles);
  ASSERT_FALSE(tree.encloses(outside));
  const double size = surface.box().longest_side();
  for (const Vec3 aim : corners_and_edges(surface)) {
    const CrossingCounts counts = tree.crossings(outside, aim - outside);
    ASSERT_EQ(counts.from_back, counts.from_front);
    const SurfaceHit hit = tree.ray(outside, aim - outside);
    if (!hit.triangle.valid()) {
      // Rounding may let the ray pass by an outline, but by no more than that.
      ASSERT_EQ(sum(counts), 0U);
      continue;
    }
    ASSERT_LT(length(outside + hit.parameter * (aim - outside) - hit.position),
              1e-12 * (size + length(outside)));
  }
}

TEST(TriangleTreeRay, NeverSlipsThroughEdgesAndCornersOfAClosedSurface) {
  expect_no_way_out(lattice_cube(6), {3, 3, 3});
  expect_no_way_out(lattice_cube(6), {1.25, 0.1, 5.75});
  expect_no_way_out(bumpy_sphere(20, 40, 0.1), {0.1, -0.2, 0.3});
  const Vec3 middle{6.7e6, -5e5, 3000};
  expect_no_way_out(bumpy_sphere(20, 40, 0.1, middle), middle);
  expect_no_way_out(lattice_cube(6, middle), middle + Vec3{2, 3, 4});
}

TEST(TriangleTreeRay, CrossesAClosedSurfaceAnEvenNumberOfTimesFromOutside) {
  for (const double far : {7.0, 1e3, 1e8}) {
    expect_met_from(lattice_cube(6), {far, 3, 3});
    expect_met_from(lattice_cube(6), {far, far, -far});
    expect_met_from(bumpy_sphere(20, 40, 0.1), {0, 0.3 * far, -far});
  }
}

TEST(TriangleTreeRay, HitsTheTriangleOfLowestNumberAtAnEdgeOrACorner) {
  const Surface cube = lattice_cube(4);
  const TriangleTree tree(cube.points, cube.triangles);
  // The lower side is the first; (1, 1) is a corner of six of its triangles, (1.5, 1.5) lies on a diagonal.
  for (const Vec3 from : {Vec3{1, 1, -3}, Vec3{1.5, 1.5, -3}, Vec3{2, 1.25, -3}}) {
    const SurfaceHit hit = tree.ray(from, {0, 0, 2});
    EXPECT_EQ(hit.parameter, 1.5);
    EXPECT_EQ(hit.position, (Vec3{from.x, from.y, 0}));
    std::uint32_t lowest = 0;
    const ShearedRay ray(from, {0, 0, 2});
    const auto touched = [&](std::uint32_t number) {
      TriangleCorners corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = cube.points[cube.triangles[number][i]];
      return ray.touch(corners).has_value();
    };
    while (!touched(lowest)) ++lowest;
    EXPECT_EQ(hit.triangle, TriangleId(lowest));
    std::uint32_t others = 0;
    for (std::uint32_t number = lowest + 1; number < 32; ++number) others += touched(number) ? 1 : 0;
    EXPECT_GE(others, 1U);
  }
}

TEST(TriangleTreeRay, IsWhatTryingEveryTriangleGives) {
  for (const Vec3 middle : {Vec3{}, Vec3{6.7e6, -5e5, 3000}}) {
    const Surface surface = soup(kSeed, 1500, middle);
    const TriangleTree tree(surface.points, surface.triangles);
    Draws draws(kSeed);
    int hits = 0;
    for (int i = 0; i < 1500; ++i) {
      const Vec3 origin = middle + draws.in_cube(i % 3 == 0 ? 500 : 12);
      const Vec3 direction = std::exp(draws.uniform(-20, 20)) * (middle + draws.in_cube(9) - origin);
      const ShearedRay ray(origin, direction);
      SurfaceHit first{.parameter = std::numeric_limits<double>::infinity()};
      CrossingCounts counts;
      for (std::uint32_t number = 0; number < surface.triangles.size(); ++number) {
        const OrderedTriangle triangle(surface.points, surface.triangles[number]);
        const auto crossed = ray.cross(triangle.corners);
        if (crossed && crossed->parameter >= 0)
          ++(crossed->from_front != triangle.mirrored() ? counts.from_front : counts.from_back);
        const auto touched = ray.touch(triangle.corners);
        if (!touched || touched->parameter < 0 || touched->parameter >= first.parameter) continue;
        first = {touched->parameter, point_at(touched->weights, triangle.corners), TriangleId(number),
                 triangle.as_given(touched->weights)};
      }
      const SurfaceHit hit = tree.ray(origin, direction);
      ASSERT_EQ(hit.triangle, first.triangle) << "ray " << i;
      if (hit.triangle.valid()) {
        ++hits;
        ASSERT_EQ(hit.parameter, first.parameter);
        ASSERT_EQ(hit.position, first.position);
        ASSERT_EQ(hit.weights, first.weights);
      }
      ASSERT_EQ(tree.crossings(origin, direction).from_front, counts.from_front) << "ray " << i;
      ASSERT_EQ(tree.crossings(origin, direction).from_back, counts.from_back) << "ray " << i;
    }
    EXPECT_GT(hits, 700);
  }
}

TEST(TriangleTreeRay, TellsTheSideThatItComesFrom) {
  const Surface flat{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}}};
  const TriangleTree tree(flat.points, flat.triangles);
  EXPECT_EQ(tree.crossings({1, 1, 5}, {0.1, 0.1, -1}).from_front, 1U);
  EXPECT_EQ(tree.crossings({1, 1, 5}, {0.1, 0.1, -1}).from_back, 0U);
  EXPECT_EQ(tree.crossings({1, 1, -5}, {0, 0, 1}).from_back, 1U);
  EXPECT_EQ(sum(tree.crossings({1, 1, -5}, {0, 0, -1})), 0U);
}

TEST(TriangleTreeRay, TakesTrianglesWithoutAreaAndThoseSeenEdgeOn) {
  const Surface surface{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}},
                        {{0, 0, 0}, {0, 1, 1}, {0, 3, 1}, {0, 1, 2}}};
  const TriangleTree tree(surface.points, surface.triangles);
  EXPECT_EQ(tree.ray({0.5, 0, 3}, {0, 0, -1}).triangle, TriangleId(std::size_t{3}));
  EXPECT_FALSE(tree.ray({-1, 0.5, 0}, {1, 0, 0}).triangle.valid());
  EXPECT_EQ(sum(tree.crossings({-1, 0.5, 0}, {1, 0, 0})), 0U);
}

TEST(TriangleTreeEncloses, IsRightOnTheLatticeWhereRaysMeetEdgesAndCorners) {
  for (const Vec3 low : {Vec3{}, Vec3{6.7e6, -5e5, 3000}}) {
    const Surface cube = lattice_cube(4, low);
    const TriangleTree tree(cube.points, cube.triangles);
    for (double x = -0.5; x <= 4.5; x += 0.25)
      for (double y = -0.5; y <= 4.5; y += 0.25)
        for (const double z : {-1.0, 0.5, 2.0, 3.75, 5.0}) {
          const bool on_wall = x == 0 || x == 4 || y == 0 || y == 4;
          if (on_wall) continue;
          const bool inside = x > 0 && x < 4 && y > 0 && y < 4 && z > 0 && z < 4;
          ASSERT_EQ(tree.encloses(low + Vec3{x, y, z}), inside) << x << " " << y << " " << z;
        }
  }
}

TEST(TriangleTreeEncloses, IsRightForASphere) {
  const Surface sphere = bumpy_sphere(60, 120);
  const TriangleTree tree(sphere.points, sphere.triangles);
  Draws draws(kSeed);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = draws.in_cube(1.1);
    if (std::abs(length(p) - 1) > 0.003) {
      ASSERT_EQ(tree.encloses(p), length(p) < 1);
    }
  }
  // Along the axis, through the poles, where all meridians meet.
  for (const double z : {-1.5, -0.5, 0.0, 0.7, 1.5}) EXPECT_EQ(tree.encloses({0, 0, z}), std::abs(z) < 1);
}

}  // namespace
}  // namespace quarry
