#include "kernels/cleanup/ideal.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "engine/mesh/sectors.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double sector_degrees(const Mesh& mesh, std::uint32_t v) {
  return sector_angle(mesh, PlaneModel(), VertexId(v)) / kDegree;
}

TEST(SectorAngle, IsTakenThroughTheFaces) {
  // An L of three quads.
  const Mesh mesh = test::mesh_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}},
                                  {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}});
  EXPECT_NEAR(sector_degrees(mesh, 0), 90, 1e-9);
  EXPECT_NEAR(sector_degrees(mesh, 1), 180, 1e-9);
  EXPECT_NEAR(sector_degrees(mesh, 4), 270, 1e-9);
}

TEST(SectorAngle, OfATipIsAFullTurn) {
  Mesh mesh = test::triangle_lattice(4, 4);
  auto tags = ConstraintTags::add_to(mesh);
  const SideId s = mesh.find_side(VertexId(11U), VertexId(12U));
  tags.set_constrained(s, true);
  tags.set_constrained(mesh.neighbour(s), true);
  cut_open(mesh, tags);
  EXPECT_NEAR(sector_degrees(mesh, 11), 360, 1e-9);
  const auto ideal = set_ideal_faces(mesh, PlaneModel());
  EXPECT_EQ(ideal[VertexId(11U)], 4);
}

// The corner angles of the one face at the vertex add up to -160 degrees there.
TEST(SectorAngle, DoesNotDependOnTheFacesBetween) {
  const double turn = 200 * kDegree;
  const Mesh mesh =
      test::mesh_of({{0, 0}, {1, 0}, {0.5, 0.5}, {std::cos(turn), std::sin(turn)}}, {{0, 1, 2, 3}});
  EXPECT_NEAR(sector_degrees(mesh, 0), 200, 1e-9);
}

TEST(IdealFaces, AreRightAnglesOnTheBoundaryAndFourInside) {
  Mesh mesh = test::triangle_lattice(3, 3);
  const auto ideal = set_ideal_faces(mesh, PlaneModel());
  EXPECT_EQ(ideal[VertexId(0U)], 1);
  EXPECT_EQ(ideal[VertexId(1U)], 2);
  EXPECT_EQ(ideal[VertexId(5U)], 4);
  EXPECT_EQ(ideal[mesh.grow_vertices(1)], 4);
}

TEST(IdealFaces, AreOneAtLeast) {
  Mesh mesh = test::mesh_of({{0, 0}, {1, 0}, {1, 0.1}}, {{0, 1, 2}});
  EXPECT_EQ(set_ideal_faces(mesh, PlaneModel())[VertexId(0U)], 1);
}

}  // namespace
}  // namespace quarry
