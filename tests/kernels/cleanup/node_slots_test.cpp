#include "kernels/cleanup/node_slots.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"

namespace quarry {
namespace {

// Triangles around a vertex, number 0, with a piece along the edge to a ring vertex at each of the angles, in
// degrees; the ring has other vertices between, so that no sector is too wide for a triangle.
struct Fan {
  Mesh mesh;
  ConstraintTags tags;
  NodedLines lines;

  explicit Fan(const std::vector<double>& angles) {
    std::vector<double> x{0}, y{0};
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 360;
      for (int k = 0; k < kParts; ++k) {
        const double angle = (angles[i] + (next - angles[i]) * k / kParts) * std::numbers::pi / 180;
        x.push_back(std::cos(angle));
        y.push_back(std::sin(angle));
      }
    }
    std::vector<FaceCorners> faces;
    const auto count = static_cast<std::uint32_t>(x.size() - 1);
    for (std::uint32_t i = 0; i < count; ++i)
      faces.push_back({VertexId(0U), VertexId(1 + i), VertexId(1 + (i + 1) % count), VertexId()});
    mesh = build_mesh(std::move(x), std::move(y), faces);
    tags = ConstraintTags::add_to(mesh);
    tags.support[VertexId(0U)] = Support::at(lines.nodes.push_back({0, 0}));
    for (std::uint32_t i = 0; i < angles.size(); ++i) add_piece(tip(i));
  }

  // The ring vertex of a line.
  static VertexId tip(std::uint32_t line) { return VertexId(1 + kParts * line); }

  void add_piece(VertexId to) {
    // Away from the centre the piece goes on.
    const NodeId far = lines.nodes.push_back(2.0 * mesh.point(to));
    tags.support[to] = Support::on(lines.pieces.push_back({far, NodeId(0U)}));
    const SideId s = mesh.find_side(VertexId(0U), to);
    tags.set_constrained(s, true);
    tags.set_constrained(mesh.neighbour(s), true);
  }

  void end_at_tip(std::uint32_t line) { tags.support[tip(line)] = Support::at(NodeId(line + 1)); }

  // Faces that its sectors are to have, from that of the first line on; empty if it is not regular.
  [[nodiscard]] std::vector<int> ideals() const {
    const auto arms = NodeSlots(lines).arms_of(mesh, tags, VertexId(0U));
    std::vector<int> ideals;
    for (int i = 0; arms && i < arms->count(); ++i) ideals.push_back(arms->ideal(i));
    return ideals;
  }

  [[nodiscard]] bool regular() const { return find_regular_nodes(mesh, tags, NodeSlots(lines))[0] != 0; }

 private:
  static constexpr int kParts = 4;
};

TEST(NodeSlots, AreThoseThatTheAnglesAreNearestTo) {
  EXPECT_EQ(Fan({0, 90, 180, 270}).ideals(), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(Fan({0, 60, 180, 250}).ideals(), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(Fan({0, 80, 170}).ideals(), (std::vector{1, 1, 2}));
  EXPECT_EQ(Fan({0, 160}).ideals(), (std::vector{2, 2}));
  EXPECT_EQ(Fan({0, 100}).ideals(), (std::vector{1, 3}));
  EXPECT_EQ(Fan({30}).ideals(), (std::vector{4}));
}

TEST(NodeSlots, AreNoneWhereARegularVertexCannotHoldTheLines) {
  EXPECT_TRUE(Fan({0, 72, 144, 216, 288}).ideals().empty());  // five lines
  EXPECT_TRUE(Fan({0, 30, 180, 210}).ideals().empty());       // two of them side by side
  EXPECT_TRUE(Fan({0, 120, 240}).ideals().empty());           // a right angle is left over
}

TEST(NodeSlots, DoNotFollowTheVerticesOfAMesh) {
  Fan fan({0, 130});
  ASSERT_EQ(fan.ideals(), (std::vector{1, 3}));
  fan.mesh.set_point(Fan::tip(1), {std::cos(2.5), std::sin(2.5)});  // 143 degrees
  EXPECT_EQ(fan.ideals(), (std::vector{1, 3}));
}

// Tips on the boundary are nodes that are not regular: edges to them stay cut open.
TEST(RegularNodes, StayInOnePieceUnlessTwoOfTheirEdgesAreCutOpen) {
  Fan fan({0, 90, 180, 270});
  EXPECT_TRUE(fan.regular());
  fan.end_at_tip(0);
  EXPECT_TRUE(fan.regular());
  fan.end_at_tip(2);
  EXPECT_FALSE(fan.regular());
}

TEST(RegularNodes, AreNoneAtADeadEndWhoseOnlyEdgeIsCutOpen) {
  Fan fan({30});
  EXPECT_TRUE(fan.regular());
  fan.end_at_tip(0);
  EXPECT_FALSE(fan.regular());
}

}  // namespace
}  // namespace quarry
