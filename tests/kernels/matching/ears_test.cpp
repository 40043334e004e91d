#include "kernels/matching/ears.hpp"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/quad_shape.hpp"
#include "tests/kernels/matching/triangle_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

using test::boundary_of;
using test::constraints_of;

// The tip of a wedge at 0: its triangle can be merged across 1-3 only, and 0, 1 and 2 are on one line.
Mesh wedge() {
  return test::mesh_of({{0, 0}, {1, 0}, {2, 0}, {1, 0.3}, {2, 1}, {0, 1}},
                       {{0, 1, 3}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}});
}

Mesh tagged(Mesh mesh) {
  (void)ConstraintTags::add_to(mesh);
  return mesh;
}

// The same points on a slope.
Mesh in_space(const Mesh& flat) {
  std::vector<double> x = flat.xs(), y = flat.ys(), z;
  for (std::size_t i = 0; i < x.size(); ++i) z.push_back(0.5 * x[i] - 0.2 * y[i]);
  std::vector<FaceCorners> faces;
  for (const FaceId f : flat.faces())
    faces.push_back({flat.corner(f, 0), flat.corner(f, 1), flat.corner(f, 2), VertexId()});
  return build_mesh(std::move(x), std::move(y), std::move(z), faces);
}

EarReport open_ears(Mesh& mesh) {
  EarReport report;
  open_forced_ears(mesh, ConstraintTags::of(mesh), {}, report);
  return report;
}

TEST(Ears, AreOpenedSoThatTheQuadAtTheTipIsConvex) {
  Mesh mesh = tagged(wedge());
  const test::Ends boundary = boundary_of(mesh);
  const EarReport report = open_ears(mesh);
  EXPECT_EQ(report.forced, 2U);  // and the triangle at 5
  EXPECT_EQ(report.bad, 1U);
  EXPECT_EQ(report.opened, 1U);
  EXPECT_EQ(mesh.count_alive_faces(), 6U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(boundary_of(mesh), boundary);
  // The new vertex lies on the edge from 2 to 3.
  const Vec2 x = mesh.point(VertexId(std::size_t{6}));
  EXPECT_NEAR(cross(Vec2{1, 0.3} - Vec2{2, 0}, x - Vec2{2, 0}), 0, 1e-15);

  MatchingReport matching;
  const DualArcs join = find_join(mesh, ConstraintTags::of(mesh), {}, matching, Progress());
  const Mesh quads = merge_join(std::move(mesh), join);
  for (const FaceId f : quads.faces()) EXPECT_TRUE(matching::is_convex(quads, f));
}

TEST(Ears, StayWhereTheEdgeToSplitIsALine) {
  Mesh mesh = tagged(wedge());
  ConstraintTags::of(mesh).set_constrained(mesh.find_side(VertexId(std::size_t{2}), VertexId(std::size_t{3})),
                                           true);
  const EarReport report = open_ears(mesh);
  EXPECT_GT(report.bad, 0U);
  EXPECT_EQ(report.opened, 0U);
  EXPECT_EQ(mesh.count_alive_faces(), 4U);
}

TEST(Ears, StayWhereTheOnlyMergeIsGood) {
  Mesh mesh = tagged(test::mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}));
  const EarReport report = open_ears(mesh);
  EXPECT_EQ(report.forced, 2U);
  EXPECT_EQ(report.bad, 0U);
  EXPECT_EQ(mesh.count_alive_faces(), 2U);
}

TEST(Ears, AreOpenedInSpaceAsInThePlane) {
  Mesh mesh = tagged(in_space(wedge()));
  const EarReport report = open_ears(mesh);
  EXPECT_EQ(report.opened, 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  const Vec3 x = mesh.point3(VertexId(std::size_t{6}));
  EXPECT_NEAR(x.z, 0.5 * x.x - 0.2 * x.y, 1e-15);
}

// Triangles with one arc whose only merge is not convex.
std::size_t count_folded(const Mesh& mesh, ConstraintTags tags) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    SideId only;
    int arcs = 0;
    for (int k = 0; k < 3; ++k) {
      if (!matching::joinable(mesh, tags, SideId(f, k))) continue;
      only = SideId(f, k);
      ++arcs;
    }
    if (arcs != 1) continue;
    const auto at = [&](VertexId v) { return mesh.point(v); };
    const VertexId beyond = matching::apex(mesh, mesh.neighbour(only));
    count += matching::is_convex(
                 {at(mesh.origin(only)), at(beyond), at(mesh.target(only)), at(matching::apex(mesh, only))})
                 ? 0
                 : 1;
  }
  return count;
}

TEST(Ears, KeepLinesValidityChargeAndParityOnRandomMeshes) {
  std::uint64_t opened = 0;
  std::size_t folded_before = 0, folded_after = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.seed = seed, .crooked_lines = 40, .slivers = 0.1});
    const test::Ends boundary = boundary_of(made.mesh), lines = constraints_of(made.mesh);
    const int charge = test::charge_of(made.mesh);
    const std::size_t faces = made.mesh.count_alive_faces();
    const std::size_t folded = count_folded(made.mesh, made.tags);
    const EarReport report = open_ears(made.mesh);
    EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(boundary_of(made.mesh), boundary);
    EXPECT_EQ(constraints_of(made.mesh), lines);
    EXPECT_EQ(test::charge_of(made.mesh), charge);
    EXPECT_EQ(made.mesh.count_alive_faces(), faces + 2 * report.opened);
    EXPECT_LE(report.opened, report.bad);
    EXPECT_LE(report.bad, report.forced);
    opened += report.opened;
    const std::size_t after = count_folded(made.mesh, made.tags);
    EXPECT_LE(after, folded);
    folded_before += folded;
    folded_after += after;
  }
  EXPECT_GT(opened, 0U);
  EXPECT_LT(folded_after, folded_before);
}

}  // namespace
}  // namespace quarry
