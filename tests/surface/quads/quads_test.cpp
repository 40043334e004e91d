#include "surface/quads/quads.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/quality/summary.hpp"
#include "surface/feature/bind.hpp"
#include "surface/quads/slide_on_features.hpp"
#include "surface/remesh/remesh.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

struct Quads {
  Mesh mesh;
  SurfaceQuadReport report;
  CurveNetwork network;
};

Quads quads_of(TriangleSurface surface, double edge, CleanUpLevel level = CleanUpLevel::kFull) {
  const RepairedSurface repaired = repair_surface(std::move(surface), {});
  const FeatureOptions features{.size = 2 * edge};
  const CurveNetwork network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, features).edges, features);
  Mesh triangles = make_sheets(repaired);
  const SurfaceModel model(triangles, bind_features(triangles, network), 0.5 * edge);
  remesh_surface(triangles, model, network, SurfaceSizes(2.2 * edge), {}, Progress());
  SurfaceQuadOptions options;
  options.cleanup = level;
  Quads result;
  result.mesh = make_surface_quads(std::move(triangles), model, network, options, result.report, Progress());
  result.network = network;
  return result;
}

void expect_quads(const Mesh& mesh) {
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  for (const FaceId f : mesh.faces()) ASSERT_EQ(mesh.corner_count(f), 4);
  EXPECT_GT(summarize_quality(mesh).quads.scaled_jacobian.min, 0.2);
}

TEST(SurfaceQuads, OfASphereAreManyRegularAndOnIt) {
  const Quads quads = quads_of(test::sphere(5), 0.08);
  expect_quads(quads.mesh);
  const QualitySummary quality = summarize_quality(quads.mesh);
  EXPECT_GT(quality.quads.scaled_jacobian.mean, 0.95);
  EXPECT_LT(quality.valence.irregular_share(), 0.03);
  EXPECT_NEAR(quality.area, 4 * std::numbers::pi, 0.05);
  for (const VertexId v : quads.mesh.vertices()) EXPECT_NEAR(length(quads.mesh.point3(v)), 1, 2e-3);
}

TEST(SurfaceQuads, CleanUpLeavesFewerIrregularVertices) {
  const auto share = [](CleanUpLevel level) {
    return summarize_quality(quads_of(test::sphere(5), 0.1, level).mesh).valence.irregular_share();
  };
  EXPECT_LT(4 * share(CleanUpLevel::kFull), share(CleanUpLevel::kNone));
}

TEST(SurfaceQuads, OfACubeKeepItsEdges) {
  const Quads quads = quads_of(test::cube(), 0.06);
  expect_quads(quads.mesh);
  EXPECT_NEAR(summarize_quality(quads.mesh).area, 6, 1e-9);
  const ConstraintTags tags = ConstraintTags::of(quads.mesh);
  double kept = 0;
  for (const FaceId f : quads.mesh.faces())
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      if (tags.constrained(s) && s < quads.mesh.neighbour(s))
        kept += length(quads.mesh.point3(quads.mesh.target(s)) - quads.mesh.point3(quads.mesh.origin(s)));
    }
  EXPECT_NEAR(kept, 12, 1e-9);
}

TEST(SurfaceQuads, HaveVerticesThatSlideBackToGoodPlacesAlongEdges) {
  Quads quads = quads_of(test::cube(), 0.1);
  const ConstraintTags tags = ConstraintTags::of(quads.mesh);
  const double good = summarize_quality(quads.mesh).quads.scaled_jacobian.mean;
  for (const VertexId v : quads.mesh.vertices()) {
    if (!tags.support[v].slides() || v.value() % 5 != 0) continue;
    Vec3 aside;
    for_each_constrained_neighbour(quads.mesh, tags, v, [&](VertexId w) { aside = quads.mesh.point3(w); });
    quads.mesh.set_point3(v, quads.mesh.point3(v) + 0.4 * (aside - quads.mesh.point3(v)));
  }
  const double bad = summarize_quality(quads.mesh).quads.scaled_jacobian.mean;
  ASSERT_LT(bad, good - 0.01);
  EXPECT_GT(slide_on_features(quads.mesh, tags, quads.network, 10, Progress()).moved, 0U);
  EXPECT_GT(summarize_quality(quads.mesh).quads.scaled_jacobian.mean, good - 0.1 * (good - bad));
  EXPECT_NEAR(summarize_quality(quads.mesh).area, 6, 1e-9);
}

TEST(SurfaceQuads, OfATerrainKeepItsRim) {
  const auto height = [](double x, double y) { return 0.1 * std::sin(7 * x) * std::cos(5 * y); };
  const Quads quads = quads_of(test::terrain(40, 40, height), 0.03);
  expect_quads(quads.mesh);
  double rim = 0;
  for (const VertexId v : quads.mesh.vertices()) {
    if (!quads.mesh.on_boundary(v)) continue;
    const Vec3 p = quads.mesh.point3(v);
    rim = std::max(rim, std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y)));
  }
  EXPECT_LT(rim, 1e-12);
}

// At its rim the surface turns back within less than a hundredth of an element.
TEST(SurfaceQuads, OfAThinLensHaveNoFaceThatIsTurnedOver) {
  TriangleSurface lens = test::sphere(5);
  for (Vec3& p : lens.points) p.z *= 0.03;
  for (const double edge : {0.2, 0.1, 0.05}) {
    const Quads quads = quads_of(lens, edge);
    EXPECT_EQ(quads.report.turned_over, 0U) << edge;
    EXPECT_EQ(validate(quads.mesh, GeometryCheck::kNone), "");
    EXPECT_GT(summarize_quality(quads.mesh).quads.scaled_jacobian.min, 0) << edge;
  }
}

TEST(SurfaceQuads, ReachTheTipsOfTheSurface) {
  TriangleSurface spiny = test::sphere(5);
  // A blunt thorn, narrower than an element.
  for (Vec3& p : spiny.points)
    if (p.z > 0.999) p.z += 0.06;
  Vec3 tip;
  for (const Vec3 p : spiny.points) tip = p.z > tip.z ? p : tip;
  const Quads quads = quads_of(spiny, 0.1);
  EXPECT_GT(quads.report.reached, 0U);
  double least = 1;
  for (const VertexId v : quads.mesh.vertices()) least = std::min(least, length(quads.mesh.point3(v) - tip));
  EXPECT_LT(least, 0.02);
  EXPECT_GT(summarize_quality(quads.mesh).quads.scaled_jacobian.min, 0.15);
}

// All vertices of the surface lie on its rim.
TEST(SurfaceQuads, ReachARidgeWhereTheSurfaceHasNoVertices) {
  const auto height = [](double x, double) { return 0.06 * std::exp(-std::pow((x - 0.5) / 0.04, 2)); };
  const Quads quads = quads_of(test::terrain(80, 1, height), 0.07);
  EXPECT_GT(quads.report.reached, 0U);
  double lowest = 1;  // of the highest vertices of strips across the ridge
  for (double y = 0.2; y < 0.8; y += 0.2) {
    double highest = 0;
    for (const VertexId v : quads.mesh.vertices()) {
      const Vec3 p = quads.mesh.point3(v);
      if (std::abs(p.y - y) < 0.1) highest = std::max(highest, p.z);
    }
    lowest = std::min(lowest, highest);
  }
  EXPECT_GT(lowest, 0.05);
}

TEST(SurfaceQuadThreads, GiveTheSameMeshOnAnyNumber) {
  const auto height = [](double x, double y) { return 0.2 * std::sin(9 * x + y) * std::cos(8 * y); };
  std::vector<std::uint64_t> serial;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const Quads quads = quads_of(test::terrain(40, 40, height), 0.03);
      if (threads == 1) serial = test::arrays_of(quads.mesh);
      EXPECT_EQ(test::arrays_of(quads.mesh), serial) << threads;
    });
    if (threads > 1) {
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
    }
  }
}

}  // namespace
}  // namespace quarry
