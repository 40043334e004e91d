#include "kernels/cleanup/node_arms.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"

namespace quarry {
namespace {

// Triangles around a vertex, number 0, with a constrained edge to each ring vertex at one of the angles, in
// degrees; the ring has other vertices between, so that no sector is too wide for a triangle.
struct Fan {
  Mesh mesh;
  ConstraintTags tags;

  explicit Fan(const std::vector<double>& lines) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double next = i + 1 < lines.size() ? lines[i + 1] : lines[0] + 360;
      for (int k = 0; k < 4; ++k) angles.push_back(lines[i] + (next - lines[i]) * k / 4);
    }
    std::vector<double> x{0}, y{0};
    for (const double angle : angles) {
      x.push_back(std::cos(angle * std::numbers::pi / 180));
      y.push_back(std::sin(angle * std::numbers::pi / 180));
    }
    std::vector<FaceCorners> faces;
    const auto count = static_cast<std::uint32_t>(angles.size());
    for (std::uint32_t i = 0; i < count; ++i)
      faces.push_back({VertexId(0U), VertexId(1 + i), VertexId(1 + (i + 1) % count), VertexId()});
    mesh = build_mesh(std::move(x), std::move(y), faces);
    tags = ConstraintTags::add_to(mesh);
    tags.support[VertexId(0U)] = Support::at(NodeId(0U));
    for (std::uint32_t i = 0; i < count; i += 4) constrain(VertexId(0U), VertexId(1 + i));
  }

  void constrain(VertexId a, VertexId b) {
    const SideId s = mesh.find_side(a, b);
    tags.set_constrained(s, true);
    tags.set_constrained(mesh.neighbour(s), true);
    tags.support[b] = Support::on(PieceId(0U));
  }

  // Faces that its sectors are to have, from that of the first line on; empty if it cannot be regular.
  [[nodiscard]] std::vector<int> ideals() const {
    const auto arms = arms_of(mesh, tags, VertexId(0U));
    std::vector<int> ideals;
    for (int i = 0; arms && i < arms->count; ++i) ideals.push_back(arms->ideal(i));
    return ideals;
  }
};

TEST(NodeArms, TakeTheSlotsThatTheirAnglesAreNearTo) {
  EXPECT_EQ(Fan({0, 90, 180, 270}).ideals(), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(Fan({0, 60, 180, 250}).ideals(), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(Fan({0, 80, 170}).ideals(), (std::vector{1, 1, 2}));
  EXPECT_EQ(Fan({0, 160}).ideals(), (std::vector{2, 2}));
  EXPECT_EQ(Fan({0, 100}).ideals(), (std::vector{1, 3}));
  EXPECT_EQ(Fan({30}).ideals(), (std::vector{4}));
}

TEST(NodeArms, AreNoneWhereARegularVertexCannotHoldThem) {
  EXPECT_TRUE(Fan({0, 72, 144, 216, 288}).ideals().empty());  // five lines
  EXPECT_TRUE(Fan({0, 30, 180, 210}).ideals().empty());       // two of them side by side
  EXPECT_TRUE(Fan({0, 120, 240}).ideals().empty());           // a right angle is left over
  EXPECT_TRUE(Fan({0, 135.5}).ideals().empty());              // neither a bend nor a corner
}

TEST(RegularNodes, StayInOnePieceUnlessTwoOfTheirEdgesAreCutOpen) {
  const auto regular = [](const Fan& fan) { return find_regular_nodes(fan.mesh, fan.tags)[0] != 0; };
  Fan fan({0, 90, 180, 270});
  EXPECT_TRUE(regular(fan));
  fan.tags.support[VertexId(1U)] = Support::at(NodeId(1U));  // on the boundary: cut open
  EXPECT_TRUE(regular(fan));
  fan.tags.support[VertexId(9U)] = Support::at(NodeId(2U));
  EXPECT_FALSE(regular(fan));
}

}  // namespace
}  // namespace quarry
