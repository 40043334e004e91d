#include "surface/lattice/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/pairing.hpp"
#include "surface/feature/bind.hpp"
#include "surface/remesh/remesh.hpp"
#include "surface/repair/sheets.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

struct Latticed {
  Mesh mesh;
  ConstraintTags tags;
  LatticeReport report;
};

// triangles: their edge, in spacings.
Latticed latticed(TriangleSurface surface, double spacing, const LatticeOptions& options = {},
                  double triangles = 0.75) {
  const RepairedSurface repaired = repair_surface(std::move(surface), {});
  const FeatureOptions features{.size = spacing};
  const CurveNetwork network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, features).edges, features);
  Latticed result;
  result.mesh = make_sheets(repaired);
  const SurfaceModel model(result.mesh, bind_features(result.mesh, network));
  const SurfaceSizes sizes(spacing);
  remesh_surface(result.mesh, model, network, sizes.times(triangles), {}, Progress());
  result.report = make_lattice(result.mesh, model, network, sizes, options, Progress());
  result.tags = ConstraintTags::of(result.mesh);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  return result;
}

double flat(double /*x*/, double /*y*/) { return 0; }

// A tube of radius 1: two closed rims without a node.
TriangleSurface hoop_of(std::uint32_t around, std::uint32_t rows, double height) {
  TriangleSurface tube = test::terrain(around, rows, flat);
  for (Vec3& p : tube.points) {
    const double angle = 2 * std::numbers::pi * p.x;
    p = {std::cos(angle), std::sin(angle), height * p.y};
  }
  RepairOptions weld;
  weld.weld = 1e-9;
  return repair_surface(std::move(tube), weld).surface;
}

// Of constrained edges, each once.
std::vector<double> feature_lengths(const Latticed& lattice) {
  const Mesh& mesh = lattice.mesh;
  std::vector<double> lengths;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const SideId t = mesh.neighbour(s);
      if (lattice.tags.constrained(s) && (!t.valid() || s < t))
        lengths.push_back(length(mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s))));
    }
  return lengths;
}

// Of the triangles those that greedy pairing leaves alone.
double share_of_singles(const Latticed& lattice) {
  PairingReport report;
  static_cast<void>(pair_triangles(lattice.mesh, lattice.tags, {}, report, Progress()));
  return static_cast<double>(report.singles) / static_cast<double>(lattice.mesh.count_alive_faces());
}

TEST(Lattice, OfASquareOfWholeCellsIsThoseCells) {
  const Latticed lattice = latticed(test::terrain(20, 20, flat), 0.1);
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 200U);
  EXPECT_EQ(lattice.mesh.count_alive_vertices(), 121U);
  for (const VertexId v : lattice.mesh.vertices())
    for (const double x : {lattice.mesh.point3(v).x, lattice.mesh.point3(v).y})
      EXPECT_NEAR(10 * x, std::round(10 * x), 0.02);
}

TEST(Lattice, OfACubeDividesEachEdgeIntoWholeSpacings) {
  const Latticed lattice = latticed(test::cube(), 0.125);
  const std::vector<double> lengths = feature_lengths(lattice);
  EXPECT_EQ(lengths.size(), 12U * 8U);
  for (const double edge : lengths) EXPECT_NEAR(edge, 0.125, 1e-3);
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 6U * 64U * 2U);
}

TEST(Lattice, OfASphereLiesOnItAndHasFewTrianglesWithoutAPartner) {
  const Latticed lattice = latticed(test::sphere(5), 0.12);
  for (const VertexId v : lattice.mesh.vertices()) EXPECT_NEAR(length(lattice.mesh.point3(v)), 1, 2e-3);
  for (const FaceId f : lattice.mesh.faces()) {
    const Vec3 a = lattice.mesh.point3(lattice.mesh.corner(f, 0));
    const Vec3 b = lattice.mesh.point3(lattice.mesh.corner(f, 1));
    const Vec3 c = lattice.mesh.point3(lattice.mesh.corner(f, 2));
    EXPECT_GT(dot(cross(b - a, c - a), a + b + c), 0);
  }
  EXPECT_LT(share_of_singles(lattice), 0.06);
  EXPECT_GE(lattice.report.singularities, 8U);
}

TEST(Lattice, HasTheWantedNumberOfCellsWhateverTheSpacing) {
  for (const double wanted : {700.0, 800.0, 900.0}) {
    const Latticed lattice = latticed(test::sphere(5), 0.125, {.wanted_cells = wanted});
    EXPECT_NEAR(static_cast<double>(lattice.mesh.count_alive_faces()) / 2, wanted, 0.05 * wanted);
  }
}

TEST(Lattice, KeepsClosedRims) {
  const Latticed lattice = latticed(hoop_of(64, 24, 2), 0.2);
  double rims = 0;
  for (const double edge : feature_lengths(lattice)) rims += edge;
  EXPECT_NEAR(rims, 4 * std::numbers::pi, 0.1);
  EXPECT_LT(share_of_singles(lattice), 0.05);
}

// A hoop of one row of triangles, each a sixth of the spacing long: the estimate of the cells would be
// negative.
TEST(Lattice, OfATinyHoopHasASpacingThatIsANumber) {
  const Latticed lattice = latticed(hoop_of(36, 1, 0.17), 1, {.wanted_cells = 3}, 0.17);
  EXPECT_GT(lattice.report.scale, 0);
  EXPECT_GT(lattice.mesh.count_alive_faces(), 0U);
  for (const VertexId v : lattice.mesh.vertices()) EXPECT_LT(length(lattice.mesh.point3(v)), 1.1);
}

TEST(LatticeThreads, GiveTheSameMeshOnAnyNumber) {
  const auto height = [](double x, double y) { return 0.2 * std::sin(9 * x + y) * std::cos(8 * y); };
  std::vector<std::uint64_t> serial;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const Latticed lattice = latticed(test::terrain(40, 40, height), 0.06, {.wanted_cells = 300});
      if (threads == 1) serial = test::arrays_of(lattice.mesh);
      EXPECT_EQ(test::arrays_of(lattice.mesh), serial) << threads;
    });
    if (threads > 1) {
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
    }
  }
}

}  // namespace
}  // namespace quarry
