#include "surface/model/far_points.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/modelled_surface.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

constexpr std::array kTops = {Vec3{0.25, 0.25, 0.3}, Vec3{0.75, 0.5, 0.1}};

TEST(FarPoints, AreTheTopsOfHillsThatAFlatMeshLeavesOut) {
  const test::ModelledSurface hills = test::modelled(test::narrow_hills(kTops, 0.02));
  const test::ModelledSurface flat =
      test::modelled(test::terrain(10, 10, [](double, double) { return 0.0; }));
  // Its triangles are as large as squares of edge 0.071.
  const std::vector<Vec3> both = find_lost_places(flat.mesh, hills.model, 0.6, 0.3);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_LT(length(both[0] - kTops[0]), 1e-6);
  EXPECT_LT(length(both[1] - kTops[1]), 1e-6);
  EXPECT_EQ(find_lost_places(flat.mesh, hills.model, 2, 0.3).size(), 1U);
  EXPECT_EQ(find_lost_places(flat.mesh, hills.model, 5, 0.3).size(), 0U);
  EXPECT_EQ(find_lost_places(hills.mesh, hills.model, 0.01, 0.1).size(), 0U);
}

TEST(FarPoints, HaveTheNearestFaceOnTheirSideOfAWall) {
  const test::ModelledSurface cube = test::modelled(test::cube(1));
  // The faces of a far smaller cube: what looks along +x is near the face at x = 1 only.
  const test::ModelledSurface inner = test::modelled(test::cube(0.25, {0.375, 0.375, 0.375}));
  const auto points = cube.model.free_points().size();
  std::vector<std::uint32_t> all(points);
  std::iota(all.begin(), all.end(), 0U);
  for (const NearestFace& near : find_nearest_faces(inner.mesh, cube.model, all)) {
    EXPECT_TRUE(near.face.valid());
    EXPECT_GE(near.distance, 0.375);
  }
}

}  // namespace
}  // namespace quarry
