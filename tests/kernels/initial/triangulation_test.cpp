#include "kernels/initial/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

struct PointSet {
  std::string name;
  std::vector<Vec2> points;
};

std::vector<Vec2> random_points(std::uint64_t seed, std::size_t count, Vec2 origin, double size) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(
        {origin.x + size * uniform01(seed, 2 * i), origin.y + size * uniform01(seed, 2 * i + 1)});
  return points;
}

std::vector<Vec2> square_lattice(int columns, int rows, Vec2 origin, double step) {
  std::vector<Vec2> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      points.push_back({origin.x + step * column, origin.y + step * row});
  return points;
}

std::vector<PointSet> point_sets() {
  std::vector<PointSet> sets;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::size_t count = 3 + static_cast<std::size_t>(uniform01(99, seed) * 400);
    sets.push_back({"random, seed " + std::to_string(seed), random_points(seed, count, {0, 0}, 1)});
  }
  sets.push_back(
      {"map coordinates with centimetre detail", random_points(77, 500, {465'000.25, 6'691'000.75}, 1)});
  sets.push_back({"square lattice", square_lattice(17, 23, {0, 0}, 1)});
  sets.push_back({"square lattice far away", square_lattice(20, 20, {6.7e6, 6.7e6}, 0.01)});
  sets.push_back({"two rows", square_lattice(40, 2, {-3, 5}, 0.25)});
  sets.push_back({"two columns", square_lattice(2, 40, {-3, 5}, 0.25)});
  sets.push_back({"one triangle", {{0, 0}, {1, 0}, {0, 1}}});
  sets.push_back({"one triangle, turned right", {{0, 0}, {0, 1}, {1, 0}}});
  std::vector<Vec2> line_and_one;
  for (int i = 0; i < 50; ++i) line_and_one.push_back({0.5 * i, 0.25 * i});
  line_and_one.push_back({3, 40});
  sets.push_back({"a line and one point", line_and_one});
  std::vector<Vec2> circle;
  for (const int x : {-63, -60, -56, -52, -39, -33, -25, -16, 0, 16, 25, 33, 39, 52, 56, 60, 63, 65, -65}) {
    const double y = std::round(std::sqrt(65.0 * 65.0 - x * x));
    circle.push_back({static_cast<double>(x), y});
    if (y > 0) circle.push_back({static_cast<double>(x), -y});
  }
  sets.push_back({"exactly on one circle", circle});
  std::vector<Vec2> clusters = random_points(5, 200, {0, 0}, 1);
  const std::vector<Vec2> dense = random_points(6, 300, {0.4, 0.4}, 1e-9);
  clusters.insert(clusters.end(), dense.begin(), dense.end());
  sets.push_back({"a dense cluster", clusters});
  return sets;
}

// Corners of the convex hull with all points on its sides, by Andrew's monotone chain.
std::size_t count_hull_points(std::vector<Vec2> points) {
  const auto before = [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  std::size_t count = 0;
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<Vec2> chain;
    for (const Vec2 p : points) {
      while (chain.size() > 1 && orient2d(chain[chain.size() - 2], chain.back(), p) < 0) chain.pop_back();
      chain.push_back(p);
    }
    count += chain.size() - 1;
    std::reverse(points.begin(), points.end());
  }
  return count;
}

std::size_t count_boundary_sides(const Mesh& mesh) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) count += mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
  return count;
}

TEST(DelaunayTriangulation, HasNoPointInsideTheCircleOfATriangle) {
  for (const PointSet& set : point_sets()) {
    SCOPED_TRACE(set.name);
    const Mesh mesh = delaunay_triangulation(set.points);
    for (const FaceId f : mesh.faces())
      for (const Vec2 p : set.points)
        ASSERT_LE(incircle(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)),
                           mesh.point(mesh.corner(f, 2)), p),
                  0);
  }
}

TEST(DelaunayTriangulation, IsAValidMeshWhoseVerticesAreThePoints) {
  for (const PointSet& set : point_sets()) {
    SCOPED_TRACE(set.name);
    const Mesh mesh = delaunay_triangulation(set.points);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    ASSERT_EQ(mesh.count_alive_vertices(), set.points.size());
    for (const VertexId v : mesh.vertices()) EXPECT_EQ(mesh.point(v), set.points[v.value()]);
  }
}

TEST(DelaunayTriangulation, CoversTheConvexHullAndCountsAsEulerSays) {
  for (const PointSet& set : point_sets()) {
    SCOPED_TRACE(set.name);
    const Mesh mesh = delaunay_triangulation(set.points);
    const std::size_t hull = count_hull_points(set.points);
    EXPECT_EQ(count_boundary_sides(mesh), hull);
    EXPECT_EQ(mesh.face_slots(), 2 * set.points.size() - 2 - hull);
  }
}

// Points of a small grid, drawn at random: nothing but ties.
TEST(DelaunayTriangulation, HoldsForThousandsOfSubsetsOfSmallGrids) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int columns = 2 + static_cast<int>(seed % 6);
    const int rows = 2 + static_cast<int>(seed / 6 % 5);
    std::vector<Vec2> points;
    for (const Vec2 p : square_lattice(columns, rows, {-2, 7}, 1))
      if (uniform01(seed, points.size() + static_cast<std::uint64_t>((p.x + 2) * 64 + p.y)) < 0.6)
        points.push_back(p);
    const bool on_a_line = std::all_of(points.begin(), points.end(), [&](Vec2 p) {
      return points.size() < 3 || orient2d(points.front(), points.back(), p) == 0;
    });
    if (on_a_line) {
      EXPECT_THROW((void)delaunay_triangulation(points), Error);
      continue;
    }
    const Mesh mesh = delaunay_triangulation(points);
    ASSERT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    ASSERT_EQ(mesh.face_slots(), 2 * points.size() - 2 - count_hull_points(points));
    for (const FaceId f : mesh.faces())
      for (const Vec2 p : points)
        ASSERT_LE(incircle(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)),
                           mesh.point(mesh.corner(f, 2)), p),
                  0);
  }
}

TEST(DelaunayTriangulation, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<Vec2> points = random_points(3, 20'000, {465'000.25, 6'691'000.75}, 100);
  std::vector<VertexId> serial;
  const auto corners_of = [](const Mesh& mesh) {
    std::vector<VertexId> corners;
    for (const FaceId f : mesh.faces())
      for (int k = 0; k < 3; ++k) corners.push_back(mesh.corner(f, k));
    return corners;
  };
  parallel::with_threads(1, [&] { serial = corners_of(delaunay_triangulation(points)); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    std::vector<VertexId> other;
    parallel::with_threads(threads, [&] { other = corners_of(delaunay_triangulation(points)); });
    EXPECT_EQ(other, serial) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

void expect_refused(const std::vector<Vec2>& points, const std::string& word) {
  try {
    (void)delaunay_triangulation(points);
    FAIL() << "accepted: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
  }
}

TEST(DelaunayTriangulation, RefusesPointsOnOneLine) {
  std::vector<Vec2> points;
  for (int i = 0; i < 100; ++i) points.push_back({6.7e6 + 0.25 * i, 4e5 + 0.5 * i});
  expect_refused(points, "on one line");
}

TEST(DelaunayTriangulation, RefusesEqualPointsAndNamesThePlace) {
  expect_refused({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, "points 1 and 3 are the same");
  expect_refused({{0.0, 1}, {1, 0}, {-0.0, 1}}, "points 0 and 2 are the same");
}

TEST(DelaunayTriangulation, RefusesWhatIsNoPoint) {
  expect_refused({{0, 0}, {1, 0}}, "three points");
  expect_refused({{0, 0}, {1, 0}, {0, std::nan("")}}, "not finite");
}

}  // namespace
}  // namespace quarry
