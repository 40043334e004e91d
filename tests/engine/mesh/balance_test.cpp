#include "engine/mesh/balance.hpp"

#include <gtest/gtest.h>

#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

TEST(MeshBalance, IsFourTimesTheEulerCharacteristic) {
  EXPECT_EQ(balance_of(test::one_triangle()).charge, 4);
  EXPECT_EQ(balance_of(test::strip(7)).charge, 4);
  EXPECT_EQ(balance_of(test::annulus(8)).charge, 0);
}

TEST(MeshBalance, CountsTrianglesAndTheSidesOfTheBoundary) {
  const MeshBalance strip = balance_of(test::strip(7));
  EXPECT_EQ(strip.triangles, 7U);
  EXPECT_EQ(strip.boundary_sides, 9U);
  const MeshBalance ring = balance_of(test::annulus(8));
  EXPECT_EQ(ring.triangles, 0U);
  EXPECT_EQ(ring.boundary_sides, 16U);
}

TEST(MeshBalance, SaysWhenAMeshHasAnotherChargeOrFoldedCorners) {
  const Mesh disk = test::strip(4);
  EXPECT_EQ(find_imbalance(disk, balance_of(test::two_triangles())), "");
  EXPECT_NE(find_imbalance(disk, balance_of(test::annulus(8))), "");
  Mesh folded = test::two_triangles();
  folded.set_point(VertexId(std::size_t{1}), {0.2, 0.9});
  EXPECT_EQ(find_imbalance(folded, balance_of(disk)), "");
  EXPECT_NE(find_imbalance(folded, balance_of(disk), GeometryCheck::kPlanarCorners), "");
}

}  // namespace
}  // namespace quarry
