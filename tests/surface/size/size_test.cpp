#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "surface/feature/bind.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/size/curvature_size.hpp"
#include "surface/size/detail_size.hpp"
#include "surface/size/surface_sizes.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

Mesh mesh_of(TriangleSurface surface) {
  const RepairedSurface repaired = repair_surface(std::move(surface), {});
  const CurveNetwork network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, {}).edges, {});
  Mesh mesh = make_sheets(repaired);
  bind_features(mesh, network);
  return mesh;
}

// An ellipsoid as thin as that: at its rim the surface turns back within thickness^2.
TriangleSurface lens(double thickness, int rounds = 6) {
  TriangleSurface surface = test::sphere(rounds);
  for (Vec3& p : surface.points) p.z *= thickness;
  return surface;
}

std::vector<double> details(const Mesh& mesh, double edge) {
  return detail_sizes(mesh, ConstraintTags::of(mesh), {.edge = edge}, Progress());
}

bool limited(const std::vector<double>& sizes) {
  return std::any_of(sizes.begin(), sizes.end(), [](double s) { return std::isfinite(s); });
}

TEST(DetailSize, IsUnlimitedOnASphereOfManyEdges) {
  EXPECT_FALSE(limited(details(mesh_of(test::sphere(6)), 0.3)));
}

TEST(DetailSize, IsUnlimitedOnACubeWithItsEdgesAsFeatures) {
  EXPECT_FALSE(limited(details(mesh_of(test::cube()), 0.2)));
}

TEST(DetailSize, IsLimitedWhereAWallTurnsBack) {
  const Mesh mesh = mesh_of(lens(0.1));
  const std::vector<double> sizes = details(mesh, 0.2);
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.point3(v);
    const double radius = std::hypot(p.x, p.y);
    if (radius < 0.8) {
      EXPECT_TRUE(std::isinf(sizes[v.value()])) << radius;
    } else if (std::abs(p.z) < 1e-9) {
      EXPECT_LT(sizes[v.value()], 0.2);
    }
  }
}

TEST(DetailSize, IsUnlimitedByTheNoiseOfAScan) {
  TriangleSurface surface = test::sphere(6);
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    surface.points[i] = (1 + 0.004 * (uniform01(7, i) - 0.5)) * surface.points[i];
  EXPECT_FALSE(limited(details(mesh_of(surface), 0.2)));
}

// Vertex by vertex this would look at 16,000^2 triangles for each size that is tried.
TEST(DetailSize, OfAnEdgeLongerThanAFineSurfaceIsTheSmallestEverywhere) {
  const Mesh mesh = mesh_of(test::sphere(6));
  for (const double size : details(mesh, 1e3)) EXPECT_EQ(size, 125);
}

TEST(DetailSize, IsTheSameAtNeighboursThatAreNearBesideTheirBalls) {
  const Mesh mesh = mesh_of(lens(0.1));
  const std::vector<double> sizes = details(mesh, 2);
  std::set<double> found(sizes.begin(), sizes.end());
  EXPECT_LE(found.size(), 8U);
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.point3(v);
    if (std::hypot(p.x, p.y) > 0.9) {
      EXPECT_LE(sizes[v.value()], 1) << v.value();
    }
  }
}

TEST(DetailSize, EndsWhenItIsCancelled) {
  const Mesh mesh = mesh_of(test::sphere(3));
  CancellationToken token;
  token.cancel();
  const Progress progress({}, &token);
  EXPECT_THROW(static_cast<void>(detail_sizes(mesh, ConstraintTags::of(mesh), {.edge = 1}, progress)), Error);
}

TEST(DetailSize, IsTheSameOnAnyNumberOfThreads) {
  const Mesh mesh = mesh_of(lens(0.1));
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4, 7})
    parallel::with_threads(threads, [&] { results.push_back(details(mesh, 0.2)); });
  for (const auto& result : results) EXPECT_TRUE(result == results[0]);
}

TEST(CurvatureSize, KeepsAChordOfASphereWithinTheError) {
  const Mesh mesh = mesh_of(test::sphere(5));
  const std::vector<double> sizes =
      curvature_sizes(mesh, ConstraintTags::of(mesh), {.error = 0.001, .edge = 0.5});
  for (const VertexId v : mesh.vertices()) EXPECT_NEAR(sizes[v.value()], std::sqrt(8 * 0.001), 0.005);
}

TEST(CurvatureSize, IsUnlimitedWhereASurfaceIsFlat) {
  const Mesh mesh = mesh_of(test::cube());
  EXPECT_FALSE(limited(curvature_sizes(mesh, ConstraintTags::of(mesh), {.error = 1e-9, .edge = 0.5})));
}

TEST(CurvatureSize, GoesNoLowerThanTheSmallestShare) {
  const Mesh mesh = mesh_of(test::sphere(5));
  const CurvatureOptions options{.error = 1e-12, .edge = 0.5, .smallest = 0.25};
  for (const double size : curvature_sizes(mesh, ConstraintTags::of(mesh), options)) EXPECT_EQ(size, 0.125);
}

TEST(SurfaceSizes, GrowAwayFromWhatLimitsThem) {
  const Mesh mesh = mesh_of(test::sphere(5));
  std::vector<double> most(mesh.vertex_slots(), std::numeric_limits<double>::infinity());
  most[0] = 0.01;
  const SurfaceSizes sizes(mesh, most, 0.3, 0.2);
  EXPECT_EQ(sizes.at(VertexId(std::size_t{0})), 0.01);
  for (const VertexId v : mesh.vertices()) {
    const double far = length(mesh.point3(v) - mesh.point3(VertexId(std::size_t{0})));
    EXPECT_GE(sizes.at(v), std::min(0.2, 0.01 + 0.3 * far) - 1e-12);
    // Ways along edges are longer than straight ones.
    EXPECT_LE(sizes.at(v), std::min(0.2, 0.01 + 0.3 * 2 * far) + 1e-12);
  }
}

TEST(SurfaceSizes, AreSmallAboutTightPlacesHoweverLenient) {
  const Mesh mesh = mesh_of(test::cube());
  const std::vector<double> most(8, std::numeric_limits<double>::infinity());
  const Vec3 place{0.5, 0.5, 1};
  SurfaceSizes sizes(mesh, most, 0.5, 1, {{place, 0.01}});
  EXPECT_FALSE(sizes.uniform());
  sizes.set_leniency(16);
  const SurfacePoint there{place, TriangleId(std::uint32_t{0}), {1, 0, 0}, 0};
  const SurfacePoint beside{place + Vec3{0.1, 0, 0}, TriangleId(std::uint32_t{0}), {1, 0, 0}, 0};
  EXPECT_EQ(sizes.at(there), 0.01);
  EXPECT_NEAR(sizes.at(beside), 0.06, 1e-12);
  EXPECT_NEAR(sizes.times(2).at(there), 0.02, 1e-12);
}

TEST(SurfaceSizes, GrowWithinLargeTrianglesToo) {
  const Mesh mesh = mesh_of(test::cube());
  std::vector<double> most(8, std::numeric_limits<double>::infinity());
  const VertexId corner = mesh.corner(FaceId(std::size_t{0}), 0);
  most[corner.value()] = 0.01;
  const SurfaceSizes sizes(mesh, most, 0.5, 1);
  const Vec3 a = mesh.point3(corner), b = mesh.point3(mesh.corner(FaceId(std::size_t{0}), 1));
  const SurfacePoint middle{a + 0.5 * (b - a), TriangleId(std::uint32_t{0}), {0.5, 0.5, 0}, 0};
  EXPECT_NEAR(sizes.at(middle), 0.01 + 0.5 * 0.5 * length(b - a), 1e-12);
}

TEST(SurfaceSizes, CountTheSquaresThatHaveRoom) {
  const Mesh mesh = mesh_of(test::cube());
  std::vector<double> most(8, 0.05);
  const SurfaceSizes small(mesh, most, 0, 0.1);
  EXPECT_NEAR(small.squares(), 6 / (0.05 * 0.05), 1e-6);
  SurfaceSizes smaller = small;
  smaller.set_edge(0.01);
  EXPECT_NEAR(smaller.squares(), 6 / (0.01 * 0.01), 1e-6);
}

TEST(SurfaceSizes, AreUniformWhereNothingLimitsThem) {
  const Mesh mesh = mesh_of(test::cube());
  EXPECT_TRUE(SurfaceSizes(mesh, std::vector<double>(8, 1.0), 0.3, 0.5).uniform());
  EXPECT_TRUE(SurfaceSizes(0.5).uniform());
}

}  // namespace
}  // namespace quarry
