#include "surface/project/triangle_tree.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/surface/project/surface_samples.hpp"

namespace quarry {
namespace {

using namespace test;

const Vec3 kFarAway{6'700'000.25, -500'000.5, 3000.125};

void expect_what_looking_at_all_gives(const Surface& surface, const std::vector<Vec3>& points,
                                      const ClosestQuery& query = {}) {
  const TriangleTree tree(surface.points, surface.triangles);
  for (const Vec3 p : points) {
    const SurfacePoint expected = look_at_all(surface, p, query).best;
    const SurfacePoint found = tree.closest(p, query);
    ASSERT_TRUE(same(found, expected))
        << "at " << p.x << " " << p.y << " " << p.z << ": triangle " << found.triangle.value() << " at "
        << found.squared_distance << ", not " << expected.triangle.value() << " at "
        << expected.squared_distance;
  }
}

TEST(TriangleTreeClosest, IsWhatLookingAtEveryTriangleGives) {
  for (const std::size_t count : {1U, 2U, 7U, 100U, 1000U}) {
    const Surface surface = soup(kSeed, count);
    expect_what_looking_at_all_gives(surface, queries(surface, kSeed, 700));
  }
  const Surface sphere = bumpy_sphere(20, 40, 0.1);
  expect_what_looking_at_all_gives(sphere, queries(sphere, kSeed, 700));
}

TEST(TriangleTreeClosest, IsWhatLookingAtEveryTriangleGivesFarFromTheOrigin) {
  const Surface surface = soup(kSeed, 1000, kFarAway);
  expect_what_looking_at_all_gives(surface, queries(surface, kSeed, 700));
}

TEST(TriangleTreeClosest, IsWhatLookingAtEveryTriangleGivesAtAnyScale) {
  for (const double scale : {1e-30, 1e30}) {
    Surface surface = soup(kSeed, 300);
    for (Vec3& p : surface.points) p = scale * p;
    expect_what_looking_at_all_gives(surface, queries(surface, kSeed, 350));
  }
  const Surface surface = soup(kSeed, 300);
  expect_what_looking_at_all_gives(surface, {{1e12, 0, 0}, {-1e25, 3e24, 1}, {0, 1e60, 1e60}});
}

TEST(TriangleTreeClosest, IsTheTriangleOfLowestNumberAmongThoseEquallyNear) {
  const Surface surface = egg_box(12);
  const TriangleTree tree(surface.points, surface.triangles);
  int queries_made = 0, with_ties = 0;
  for (double x = -1; x <= 13; x += 0.5) {
    for (double y = -1; y <= 13; y += 0.5) {
      for (const double z : {-2.0, 0.0, 0.5, 1.0, 1.5, 40.0}) {
        const LookedAtAll all = look_at_all(surface, {x, y, z});
        ASSERT_TRUE(same(tree.closest({x, y, z}), all.best)) << x << " " << y << " " << z;
        ++queries_made;
        with_ties += all.ties > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(with_ties * 2, queries_made);
}

TEST(TriangleTreeClosest, HasTheSameBitsWithEveryInstructionSet) {
  std::vector<std::string> sets{"sse2", "sse4.2"};
  if (__builtin_cpu_supports("avx")) sets.emplace_back("avx");
  if (__builtin_cpu_supports("avx2")) sets.emplace_back("avx2");
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) sets.emplace_back("avx512");
  for (const Surface& surface : {egg_box(30), soup(kSeed, 2000), bumpy_sphere(30, 60, 0.2)}) {
    const TriangleTree best(surface.points, surface.triangles);
    for (const std::string& set : sets) {
      const TriangleTree tree(surface.points, surface.triangles, set);
      for (const Vec3 p : queries(surface, kSeed, 700))
        ASSERT_TRUE(same(tree.closest(p), best.closest(p)))
            << set << " at " << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(TriangleTreeClosest, DoesNotDependOnWhereTheSearchStarts) {
  Draws draws(kSeed);
  for (const Surface& surface : {egg_box(12), soup(kSeed, 500)}) {
    const TriangleTree tree(surface.points, surface.triangles);
    for (const Vec3 p : queries(surface, kSeed, 700)) {
      const SurfacePoint cold = tree.closest(p);
      for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(
            same(tree.closest(p, {.start = TriangleId(draws.below(surface.triangles.size()))}), cold));
      ASSERT_TRUE(same(tree.closest(p, {.start = cold.triangle}), cold));
    }
  }
}

TEST(TriangleTreeClosest, StaysWithinTheRadius) {
  const Surface surface = soup(kSeed, 500);
  expect_what_looking_at_all_gives(surface, queries(surface, kSeed, 700), {.radius = 0.4});
  const Surface flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const TriangleTree tree(flat.points, flat.triangles);
  EXPECT_TRUE(tree.closest({1, 1, 3}, {.radius = 3}).triangle.valid());
  EXPECT_FALSE(tree.closest({1, 1, 3}, {.radius = 2.999999999}).triangle.valid());
  EXPECT_TRUE(tree.closest({1, 1, 0}, {.radius = 0}).triangle.valid());
  EXPECT_FALSE(tree.closest({1, 1, 3}, {.radius = 2, .start = TriangleId(std::size_t{0})}).triangle.valid());
}

// Two sheets, the upper one looking up and the lower one down, a tenth apart.
Surface thin_wall(std::uint32_t side) {
  Surface wall;
  for (const double z : {0.0, 0.1})
    for (std::uint32_t y = 0; y <= side; ++y)
      for (std::uint32_t x = 0; x <= side; ++x) wall.points.push_back({1.0 * x, 1.0 * y, z});
  const std::uint32_t row = side + 1;
  for (std::uint32_t sheet = 0; sheet < 2; ++sheet) {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const std::uint32_t a = sheet * row * row + y * row + x;
        if (sheet == 0) {
          wall.triangles.push_back({a, a + row + 1, a + 1});
          wall.triangles.push_back({a, a + row, a + row + 1});
        } else {
          wall.triangles.push_back({a, a + 1, a + row + 1});
          wall.triangles.push_back({a, a + row + 1, a + row});
        }
      }
    }
  }
  return wall;
}

TEST(TriangleTreeClosest, KeepsToItsOwnSheetOfAThinWallByTheNormal) {
  const Surface wall = thin_wall(8);
  const TriangleTree tree(wall.points, wall.triangles);
  const double cosine = std::cos(0.4);
  for (const double z : {-0.2, 0.01, 0.09, 0.3}) {
    for (const double x : {0.0, 2.5, 7.9}) {
      const ClosestQuery up{.normal = {0, 0, 1}, .least_cosine = cosine};
      const ClosestQuery down{.normal = {0, 0, -1}, .least_cosine = cosine};
      EXPECT_EQ(tree.closest({x, 3.2, z}, up).position, (Vec3{x, 3.2, 0.1}));
      EXPECT_EQ(tree.closest({x, 3.2, z}, down).position, (Vec3{x, 3.2, 0}));
      const ClosestQuery aside{.normal = {1, 0, 0}, .least_cosine = cosine};
      EXPECT_FALSE(tree.closest({x, 3.2, z}, aside).triangle.valid());
    }
  }
}

TEST(TriangleTreeClosest, PassesOverTrianglesThatTurnMoreThanTheConeSays) {
  const Surface surface = soup(kSeed, 800);
  Draws draws(kSeed);
  for (int i = 0; i < 20; ++i) {
    const Vec3 axis = draws.in_cube(1);
    const ClosestQuery query{.normal = (1 / length(axis)) * axis,
                             .least_cosine = std::cos(draws.uniform(0.2, 2.5))};
    expect_what_looking_at_all_gives(surface, queries(surface, kSeed + 1, 70), query);
  }
}

TEST(TriangleTreeClosest, KeepsToTheTrianglesOfTheFilter) {
  const Surface surface = soup(kSeed, 800);
  const auto third = [](TriangleId t) { return t.value() % 3 == 1; };
  expect_what_looking_at_all_gives(surface, queries(surface, kSeed, 350), {.keep = third});
  const auto none = [](TriangleId) { return false; };
  const TriangleTree tree(surface.points, surface.triangles);
  EXPECT_FALSE(tree.closest({1, 2, 3}, {.start = TriangleId(std::size_t{4}), .keep = none}).triangle.valid());
}

TEST(TriangleTreeClosest, TakesTrianglesWithoutArea) {
  Surface surface = soup(kSeed, 200);
  Draws draws(kSeed);
  for (Triangle& t : surface.triangles) {
    if (draws.uniform(0, 1) < 0.4) t[1] = t[0];
    if (draws.uniform(0, 1) < 0.4) t[2] = t[0];
    if (draws.uniform(0, 1) < 0.2)
      surface.points[t[2]] = surface.points[t[0]] + 0.3 * (surface.points[t[1]] - surface.points[t[0]]);
  }
  const std::vector<Vec3> points = queries(surface, kSeed, 700);
  expect_what_looking_at_all_gives(surface, points);
  expect_what_looking_at_all_gives(surface, points, {.normal = {0, 0, 1}, .least_cosine = -0.9});
}

TEST(TriangleTreeClosest, TakesManyTrianglesInOnePlace) {
  Surface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {}};
  surface.triangles.assign(5000, {2, 0, 1});
  surface.triangles.front() = {3, 3, 3};
  const TriangleTree tree(surface.points, surface.triangles);
  EXPECT_EQ(tree.closest({0.25, 0.25, 1}).triangle, TriangleId(std::size_t{1}));
  EXPECT_EQ(tree.crossings({0.25, 0.25, 1}, {0, 0, -1}).from_front, 4999U);
}

TEST(TriangleTreeClosest, TakesSurfacesOfOnePointAndOfNone) {
  const Surface point{{{3, 4, 5}}, {{0, 0, 0}, {0, 0, 0}}};
  const SurfacePoint found = TriangleTree(point.points, point.triangles).closest({3, 4, 7});
  EXPECT_EQ(found.position, (Vec3{3, 4, 5}));
  EXPECT_EQ(found.triangle, TriangleId(std::size_t{0}));
  EXPECT_EQ(found.squared_distance, 4);
  const TriangleTree nothing({}, {});
  EXPECT_FALSE(nothing.closest({1, 2, 3}).triangle.valid());
  EXPECT_FALSE(nothing.ray({1, 2, 3}, {0, 0, 1}).triangle.valid());
  EXPECT_FALSE(nothing.encloses({1, 2, 3}));
}

TEST(TriangleTreeClosest, GivesWeightsOfTheCornersInTheirOwnOrder) {
  const Surface surface = soup(kSeed, 300);
  const TriangleTree tree(surface.points, surface.triangles);
  for (const Vec3 p : queries(surface, kSeed, 350)) {
    const SurfacePoint found = tree.closest(p);
    const Triangle& t = surface.triangles[found.triangle.value()];
    Vec3 mean;
    for (std::size_t i = 0; i < 3; ++i) mean = mean + found.weights[i] * surface.points[t[i]];
    EXPECT_LT(length(mean - found.position), 1e-13 * 20);
    EXPECT_NEAR(length(p - found.position), std::sqrt(found.squared_distance), 1e-12 * (1 + length(p)));
  }
}

}  // namespace
}  // namespace quarry
