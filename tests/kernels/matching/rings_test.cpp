#include "kernels/matching/rings.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"

namespace quarry {
namespace {

// Three quads around the middle node of a straight outline; that in the middle has a corner that is not
// convex across from it.
struct Fan {
  NodedLines lines;
  Mesh mesh;

  explicit Fan(double height_of_corner) {
    const auto id = [](std::uint32_t i) { return VertexId(i); };
    mesh = build_mesh(
        {0, 2, 2, 1, 0, -1, -2, -2}, {0, 0, 1, 1, height_of_corner, 1, 1, 0},
        std::vector<FaceCorners>{
            {id(0), id(1), id(2), id(3)}, {id(0), id(3), id(4), id(5)}, {id(0), id(5), id(6), id(7)}});
    ConstraintTags tags = ConstraintTags::add_to(mesh);
    const NodeId left = lines.nodes.push_back({-2, 0});
    const NodeId middle = lines.nodes.push_back({0, 0});
    const NodeId right = lines.nodes.push_back({2, 0});
    lines.pieces.push_back({left, middle, PieceKindOf::kOutline});
    lines.pieces.push_back({middle, right, PieceKindOf::kOutline});
    lines.line_begin.assign(3, 0);
    tags.support[id(7)] = Support::at(left);
    tags.support[id(0)] = Support::at(middle);
    tags.support[id(1)] = Support::at(right);
    for (const std::uint32_t i : {2U, 3U, 4U, 5U, 6U}) tags.support[id(i)] = Support::fixed();
    tags.set_constrained(SideId(FaceId(0U), 0), true);
    tags.set_constrained(SideId(FaceId(2U), 3), true);
  }
};

class RingsAtTheBoundary : public testing::TestWithParam<double> {};

TEST_P(RingsAtTheBoundary, CutTheOutlineAndMendTheFace) {
  Fan fan(GetParam());
  ASSERT_NE(validate(fan.mesh, GeometryCheck::kPlanarCorners), "");
  const PassReport report = ring_straight_corners(fan.mesh, fan.lines, {}, Progress());
  EXPECT_EQ(report.won, 1U);
  EXPECT_EQ(validate(fan.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(fan.mesh.count_alive_faces(), 9U);
  const ConstraintTags tags = ConstraintTags::of(fan.mesh);
  int constrained = 0, sliding = 0;
  for (const FaceId f : fan.mesh.faces())
    for (int k = 0; k < 4; ++k) constrained += tags.constrained(SideId(f, k)) ? 1 : 0;
  for (const VertexId v : fan.mesh.vertices()) {
    if (!tags.support[v].slides()) continue;
    ++sliding;
    EXPECT_EQ(fan.mesh.point(v).y, 0);
    EXPECT_TRUE(fan.mesh.on_boundary(v));
  }
  EXPECT_EQ(constrained, 4);
  EXPECT_EQ(sliding, 2);
}

TEST_P(RingsAtTheBoundary, AreNotMadeWhereTheBoundaryIsKept) {
  Fan fan(GetParam());
  EXPECT_EQ(ring_straight_corners(fan.mesh, fan.lines, {.keep_boundary = true}, Progress()).won, 0U);
  EXPECT_EQ(fan.mesh.count_alive_faces(), 3U);
}

// A straight corner, and reflex ones so near that the cuts must be nearer still.
INSTANTIATE_TEST_SUITE_P(OfACornerAtHeight, RingsAtTheBoundary, testing::Values(1.0, 0.6, 0.3));

}  // namespace
}  // namespace quarry
