#include "engine/mesh/pinch.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"

namespace quarry {
namespace {

// Two triangles that share the point (0, 0) and nothing else.
Mesh hourglass() {
  const auto v = [](std::uint32_t i) { return VertexId(i); };
  return build_mesh({0, 1, 1, -1, -1}, {0, -1, 1, 1, -1},
                    std::vector<FaceCorners>{{v(0), v(1), v(2), VertexId()}, {v(0), v(3), v(4), VertexId()}});
}

ConstraintTags bind_all_to_nodes(Mesh& mesh) {
  const auto tags = ConstraintTags::add_to(mesh);
  auto support = tags.support;
  for (const VertexId v : mesh.vertices()) support[v] = Support::at(NodeId(v.value()));
  return tags;
}

TEST(Pinch, EachFanGetsAVertexOfItsOwn) {
  Mesh mesh = hourglass();
  const ConstraintTags tags = bind_all_to_nodes(mesh);
  ASSERT_NE(validate(mesh, GeometryCheck::kPlanarCorners), "") << "the store allows one fan a vertex";
  EXPECT_EQ(split_pinches(mesh, tags), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  ASSERT_EQ(mesh.vertex_slots(), 6U);
  EXPECT_EQ(mesh.point(VertexId(5U)), mesh.point(VertexId(0U)));
  EXPECT_EQ(tags.support[VertexId(5U)], tags.support[VertexId(0U)]);
}

TEST(Pinch, MeshesWithoutOneStayAsTheyAre) {
  const auto v = [](std::uint32_t i) { return VertexId(i); };
  Mesh mesh = build_mesh({0, 1, 1, 0}, {0, 0, 1, 1}, std::vector<FaceCorners>{{v(0), v(1), v(2), v(3)}});
  const ConstraintTags tags = bind_all_to_nodes(mesh);
  EXPECT_EQ(split_pinches(mesh, tags), 0U);
  mark_pinches(mesh, tags);
  EXPECT_EQ(mesh.vertex_slots(), 4U);
  EXPECT_FALSE((mesh.find_tag<VertexId, std::uint8_t>(kPinchTag).valid()));
}

TEST(Pinch, AllVerticesOfThePointAreMarked) {
  Mesh mesh = hourglass();
  const ConstraintTags tags = bind_all_to_nodes(mesh);
  split_pinches(mesh, tags);
  mark_pinches(mesh, tags);
  const auto pinch = mesh.find_tag<VertexId, std::uint8_t>(kPinchTag);
  ASSERT_TRUE(pinch.valid());
  for (const VertexId v : mesh.vertices())
    EXPECT_EQ(pinch[v] != 0, v.value() == 0 || v.value() == 5) << v.value();
}

}  // namespace
}  // namespace quarry
