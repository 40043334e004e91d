#include "kernels/cluster/low_quads.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

// A quad with the corners counter-clockwise.
Mesh quad(const std::vector<Vec2>& corners) {
  std::vector<double> x, y;
  for (const Vec2 p : corners) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}};
  Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
  (void)ConstraintTags::add_to(mesh);
  return mesh;
}

bool has_edge(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return mesh.find_side(VertexId(a), VertexId(b)).valid() || mesh.find_side(VertexId(b), VertexId(a)).valid();
}

TEST(CutLowQuads, CutsAStraightCornerInTwo) {
  Mesh mesh = quad({{0, 0}, {1, -0.01}, {2, 0}, {1, 1}});
  const LowQuadReport report = cut_low_quads(mesh, {});
  EXPECT_EQ(report.low, 1U);
  EXPECT_EQ(report.cut, 1U);
  EXPECT_TRUE(has_edge(mesh, 1, 3));
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  for (const FaceId f : mesh.faces()) EXPECT_GT(scaled_jacobian(mesh, f), 0.8);
}

TEST(CutLowQuads, LeavesOneTriangleInASharpTip) {
  // 6 degrees at the first corner, and the far corner pushed outward.
  Mesh mesh = quad({{0, 0}, {1, -0.05}, {1.2, 0}, {1, 0.05}});
  EXPECT_EQ(cut_low_quads(mesh, {}).cut, 1U);
  EXPECT_TRUE(has_edge(mesh, 1, 3));
}

TEST(CutLowQuads, KeepsALowQuadWhoseTrianglesWouldBeNoBetter) {
  // Four times as long as wide: triangles would have even smaller angles.
  Mesh mesh = quad({{0, 0}, {4, 0}, {4.98, 0.2}, {0.98, 0.2}});
  const LowQuadReport report = cut_low_quads(mesh, {});
  EXPECT_EQ(report.low, 1U);
  EXPECT_EQ(report.cut, 0U);
  EXPECT_EQ(mesh.count_alive_faces(), 1U);
}

TEST(CutLowQuads, LeavesWhatIsGoodEnough) {
  const std::vector<Vec2> rhombus = {{0, 0}, {1, 0}, {1.8, 0.6}, {0.8, 0.6}};  // of sine 0.6
  Mesh mesh = quad(rhombus);
  EXPECT_EQ(cut_low_quads(mesh, {.quality = 0.59}).low, 0U);
  EXPECT_EQ(cut_low_quads(mesh, {.quality = 0.61}).cut, 1U);
  Mesh none = quad(rhombus);
  EXPECT_EQ(cut_low_quads(none, {.quality = 0}).low, 0U);
}

TEST(CutLowQuads, CutsAConcaveQuadAtItsReflexCorner) {
  Mesh mesh = quad({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}});
  ASSERT_NE(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(cut_low_quads(mesh, {}).cut, 1U);
  EXPECT_TRUE(has_edge(mesh, 0, 2));
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(CutLowQuads, CutsNeighboursIndependently) {
  // Two flat quads that share an edge.
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)},
                                          {VertexId(3U), VertexId(2U), VertexId(4U), VertexId(5U)}};
  Mesh mesh = build_mesh({0, 1, 2, 1, 2, 1}, {0, -0.01, 0, 1, 2, 2.01}, faces);
  (void)ConstraintTags::add_to(mesh);
  ASSERT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(cut_low_quads(mesh, {.quality = 0.9}).cut, 2U);
  EXPECT_EQ(mesh.count_alive_faces(), 4U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

}  // namespace
}  // namespace quarry
