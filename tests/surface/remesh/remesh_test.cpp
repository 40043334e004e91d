#include "surface/remesh/remesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "surface/feature/bind.hpp"
#include "surface/join/divide_joins.hpp"
#include "surface/remesh/triangle_guard.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

// Shorter at one point, growing from there.
SurfaceSizes graded(const Mesh& mesh, double edge, double smallest) {
  std::vector<double> most(mesh.vertex_slots(), std::numeric_limits<double>::infinity());
  most[0] = smallest;
  return {mesh, most, 0.3, edge};
}

struct Remeshed {
  Mesh mesh;
  ConstraintTags tags;
  CurveNetwork network;
  RemeshReport report;
};

Remeshed remeshed(TriangleSurface surface, double edge) {
  RepairedSurface repaired = repair_surface(std::move(surface), {});
  const RemeshOptions options;
  const FeatureOptions features{.size = edge};
  divide_joins(repaired, {.edge = edge, .deviation = options.feature_deviation * edge, .corners = features});
  Remeshed result;
  result.network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, features).edges, features);
  result.mesh = make_sheets(repaired);
  const SurfaceModel model(result.mesh, bind_features(result.mesh, result.network));
  result.report = remesh_surface(result.mesh, model, result.network, SurfaceSizes(edge), options, Progress());
  result.tags = ConstraintTags::of(result.mesh);
  return result;
}

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const FaceId f : mesh.faces())
    volume += dot(mesh.point3(mesh.corner(f, 0)),
                  cross(mesh.point3(mesh.corner(f, 1)), mesh.point3(mesh.corner(f, 2)))) /
              6;
  return volume;
}

std::vector<double> edge_lengths(const Mesh& mesh) {
  std::vector<double> lengths;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (!mesh.neighbour(s).valid() || s < mesh.neighbour(s))
        lengths.push_back(length(mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s))));
    }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

double worst_measure(const Mesh& mesh) {
  double worst = 1;
  for (const FaceId f : mesh.faces())
    worst = std::min(worst, lo_measure(mesh.point3(mesh.corner(f, 0)), mesh.point3(mesh.corner(f, 1)),
                                       mesh.point3(mesh.corner(f, 2))));
  return worst;
}

TEST(RemeshSurface, FollowsSizesThatDiffer) {
  RepairedSurface repaired = repair_surface(test::sphere(4), {});
  const CurveNetwork network;
  Mesh mesh = make_sheets(repaired);
  const SurfaceModel model(mesh, bind_features(mesh, network));
  const Vec3 center = mesh.point3(VertexId(std::size_t{0}));
  const SurfaceSizes sizes = graded(mesh, 0.2, 0.02);
  remesh_surface(mesh, model, network, sizes, {}, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  double near = 0, nears = 0, far = 0, fars = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = mesh.point3(mesh.origin(SideId(f, k))), b = mesh.point3(mesh.target(SideId(f, k)));
      const double away = length(0.5 * (a + b) - center);
      (away < 0.1 ? near : far) += away < 0.1 || away > 1 ? length(b - a) : 0;
      (away < 0.1 ? nears : fars) += away < 0.1 || away > 1 ? 1 : 0;
    }
  EXPECT_NEAR(far / fars, 0.2, 0.03);
  EXPECT_LT(near / nears, 0.07);
  EXPECT_GT(worst_measure(mesh), 0.4);
}

TEST(RemeshSurface, MakesASphereCoarserAndFinerAsAsked) {
  for (const double edge : {0.35, 0.1, 0.05}) {
    SCOPED_TRACE(edge);
    const Remeshed result = remeshed(test::sphere(4), edge);
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
    const std::vector<double> lengths = edge_lengths(result.mesh);
    EXPECT_EQ(static_cast<std::int64_t>(result.mesh.count_alive_vertices()) -
                  static_cast<std::int64_t>(lengths.size()) +
                  static_cast<std::int64_t>(result.mesh.count_alive_faces()),
              2);
    EXPECT_GT(lengths[lengths.size() / 100], 0.6 * edge);
    EXPECT_LT(lengths[lengths.size() * 99 / 100], 1.4 * edge);
    EXPECT_GT(worst_measure(result.mesh), 0.5);
    EXPECT_NEAR(volume_of(result.mesh), 4 * std::numbers::pi / 3, 0.7 * edge);
    // The surface is the one that was given, of 2048 flat triangles.
    for (const VertexId v : result.mesh.vertices()) EXPECT_NEAR(length(result.mesh.point3(v)), 1, 4e-3);
  }
}

TEST(RemeshSurface, TellsAfterOneRoundWhereTipsWereLostIfAsked) {
  const std::array tops = {Vec3{0.3, 0.3, 0.3}};
  const RepairedSurface repaired = repair_surface(test::narrow_hills(tops, 0.06), {});
  const CurveNetwork network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, {}).edges, {});
  for (const double edge : {0.2, 0.02}) {
    SCOPED_TRACE(edge);
    Mesh mesh = make_sheets(repaired);
    const SurfaceModel model(mesh, bind_features(mesh, network));
    const RemeshReport report =
        remesh_surface(mesh, model, network, SurfaceSizes(edge), {.lost_from = 0.6}, Progress());
    EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
    if (edge < 0.1) {
      EXPECT_TRUE(report.lost.empty());
      EXPECT_GT(report.rounds, 1U);
    } else {
      ASSERT_EQ(report.lost.size(), 1U);
      EXPECT_LT(length(report.lost[0] - tops[0]), edge);
      EXPECT_EQ(report.rounds, 1U);
    }
  }
}

TEST(RemeshSurface, KeepsTheEdgesAndCornersOfACube) {
  const Remeshed result = remeshed(test::cube(2, {10, 20, 30}), 0.25);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  double on_features = 0;
  for (const FaceId f : result.mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (result.tags.constrained(s) && s < result.mesh.neighbour(s))
        on_features +=
            length(result.mesh.point3(result.mesh.target(s)) - result.mesh.point3(result.mesh.origin(s)));
    }
  EXPECT_NEAR(on_features, 24, 1e-9);
  double area = 0;
  for (const FaceId f : result.mesh.faces()) {
    const Vec3 a = result.mesh.point3(result.mesh.corner(f, 0));
    area += 0.5 * length(cross(result.mesh.point3(result.mesh.corner(f, 1)) - a,
                               result.mesh.point3(result.mesh.corner(f, 2)) - a));
  }
  EXPECT_NEAR(area, 24, 1e-9) << "each face of the cube is still flat";
  EXPECT_GT(worst_measure(result.mesh), 0.4);
}

TEST(RemeshSurface, KeepsTheRimOfATerrain) {
  const auto height = [](double x, double y) { return 0.1 * std::sin(7 * x) * std::cos(5 * y); };
  const Remeshed result = remeshed(test::terrain(50, 50, height), 0.04);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  for (const VertexId v : result.mesh.vertices()) {
    const Vec3 p = result.mesh.point3(v);
    const bool at_rim = std::min({p.x, 1 - p.x, p.y, 1 - p.y}) < 1e-12;
    EXPECT_EQ(result.mesh.on_boundary(v), at_rim);
  }
}

TEST(RemeshSurface, KeepsSheetsTogetherAtTheEdgeThatTheyShare) {
  const Remeshed result = remeshed(test::three_sheets(), 0.3);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  std::vector<double> places;
  for (const VertexId v : result.mesh.vertices()) {
    const Vec3 p = result.mesh.point3(v);
    if (p.x == 0 && p.y == 0) places.push_back(p.z);
  }
  std::sort(places.begin(), places.end());
  ASSERT_EQ(places.size() % 3, 0U);
  EXPECT_GE(places.size(), 9U);
  for (std::size_t i = 0; i < places.size(); i += 3) {
    EXPECT_EQ(places[i], places[i + 1]);
    EXPECT_EQ(places[i], places[i + 2]);
    if (i > 0) {
      EXPECT_LE(places[i] - places[i - 1], 0.4 + 1e-12);
    }
  }
}

TEST(RemeshThreads, GiveTheSameMeshOnAnyNumber) {
  const auto height = [](double x, double y) { return 0.2 * std::sin(9 * x + y) * std::cos(8 * y); };
  std::vector<std::uint64_t> serial;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const Remeshed result = remeshed(test::terrain(60, 60, height), 0.03);
      if (threads == 1) serial = test::arrays_of(result.mesh);
      EXPECT_EQ(test::arrays_of(result.mesh), serial) << threads;
    });
    if (threads > 1) {
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
    }
  }
}

}  // namespace
}  // namespace quarry
