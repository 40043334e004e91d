#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "surface/model/surface_model.hpp"
#include "tests/support/modelled_surface.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

TEST(SurfaceModel, GivesTheSamePointWhereverTheSearchStarts) {
  const test::ModelledSurface sphere = test::modelled(test::sphere(4));
  std::uint64_t counter = 0;
  const auto draw = [&] { return 3 * uniform01(5, counter++) - 1.5; };
  for (int i = 0; i < 200; ++i) {
    SpacePoint p{{draw(), draw(), draw()}, {draw(), draw(), draw()}};
    const SpacePoint alone = sphere.model.project(p);
    for (const std::uint32_t start : {0U, 7U, 511U, alone.found_at}) {
      p.found_at = start;
      EXPECT_EQ(sphere.model.project(p), alone);
    }
  }
}

TEST(SurfaceModel, KnowsWhatLiesUpsideDown) {
  const test::ModelledSurface sphere = test::modelled(test::sphere(4));
  EXPECT_TRUE(sphere.model.faces_along({0, 0, 1}, {0, 0, 1}, 0.1));
  EXPECT_TRUE(sphere.model.faces_along({0, 0, 1}, {0.9, 0, 0.1}, 0.1));
  EXPECT_FALSE(sphere.model.faces_along({0, 0, 1}, {0, 0, -1}, 0.1));
  EXPECT_FALSE(sphere.model.faces_along({0, 0, 1}, {}, 0.1));
}

TEST(SurfaceModel, LetsBothSidesOfAThinWallFaceTheirWay) {
  TriangleSurface lens = test::sphere(4);
  for (Vec3& p : lens.points) p.z *= 0.01;
  const test::ModelledSurface wall = test::modelled(std::move(lens));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(wall.model.faces_along({0, 0, 0.01 * side}, {0, 0, side}, 0.001));
    // The other side is nearer than the slack.
    EXPECT_TRUE(wall.model.faces_along({0, 0, 0.01 * side}, {0, 0, -side}, 0.1));
    EXPECT_FALSE(wall.model.faces_along({0, 0, 0.01 * side}, {0, 0, -side}, 0.001));
    // It is, but beyond the reach.
    EXPECT_TRUE(wall.model.faces_along({0, 0, 0.01 * side}, {0, 0, -side}, 0.1, 0.1));
    EXPECT_FALSE(wall.model.faces_along({0, 0, 0.01 * side}, {0, 0, -side}, 0.1, 0.001));
  }
}

TEST(SurfaceModel, TellsItsPointsThatAreOnNoFeature) {
  EXPECT_EQ(test::modelled(test::cube()).model.free_points().size(), 0U);
  const test::ModelledSurface plain = test::modelled(test::terrain(4, 4, [](double, double) { return 0.0; }));
  EXPECT_EQ(plain.model.free_points().size(), 9U);
  for (const SpacePoint& p : plain.model.free_points()) EXPECT_EQ(p.up, (Vec3{0, 0, 1}));
}

TEST(SurfaceModel, HasPointsAlongEdgesThatAreLongerThanTheirSpacing) {
  const test::ModelledSurface cube = test::modelled(test::cube());
  // Along the diagonals of the sides.
  const SurfaceModel model(cube.mesh, ConstraintTags::of(cube.mesh), 0.5);
  EXPECT_EQ(model.free_points().size(), 17U);
  for (const SpacePoint& p : model.free_points()) {
    EXPECT_LT(length(model.project({p.place, Vec3()}).place - p.place), 1e-12);
    EXPECT_NEAR(length(p.up), 1, 1e-12);
  }
  EXPECT_EQ(SurfaceModel(cube.mesh, ConstraintTags::of(cube.mesh), 2).free_points().size(), 0U);
}

TEST(SurfaceModel, HasNoMorePointsAlongSliversThanTheirAreaIsWorth) {
  const test::ModelledSurface plain =
      test::modelled(test::terrain(1000, 1, [](double, double) { return 0.0; }));
  const SurfaceModel model(plain.mesh, ConstraintTags::of(plain.mesh), 0.1);
  EXPECT_GT(model.free_points().size(), 0U);
  EXPECT_LE(model.free_points().size(), 800U);
}

}  // namespace
}  // namespace quarry
