#include "kernels/quality/space_face.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace quarry {
namespace {

// A unit square that looks towards -y, with normals that turn up and down from there by an angle in degrees.
std::array<SpacePoint, 4> wall(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec3 up{0, -std::cos(angle), std::sin(angle)};
  const Vec3 down{0, -std::cos(angle), -std::sin(angle)};
  return {SpacePoint{{0, 0, 0}, down}, {{1, 0, 0}, down}, {{1, 0, 1}, up}, {{0, 0, 1}, up}};
}

TEST(FaceInSpace, MayTurnFromTheNormalsBySeventyTwoDegreesOnTheAverage) {
  for (const double degrees : {0.0, 30.0, 60.0, 72.0})
    EXPECT_EQ(scaled_jacobian_in_space(wall(degrees)), 1) << degrees;
  for (const double degrees : {73.0, 80.0, 89.0})
    EXPECT_LT(scaled_jacobian_in_space(wall(degrees)), 0) << degrees;
}

TEST(FaceInSpace, MayLieOnOneSideOfACrease) {
  std::array<SpacePoint, 4> face = wall(0);
  face[2].up = face[3].up = {0, -0.1, 0.99};
  EXPECT_EQ(scaled_jacobian_in_space(face), 1);
}

TEST(FaceInSpace, IsWorseNotConvexThanTurnedTooFar) {
  std::array<SpacePoint, 4> dart = wall(0);
  dart[2].place = {0.4, 0, 0.4};
  EXPECT_LE(scaled_jacobian_in_space(dart), kNotConvex);
  EXPECT_GT(scaled_jacobian_in_space(wall(89)), kNotConvex);
}

TEST(FaceInSpace, AsksOnlyCornersThatKnowTheirNormal) {
  std::array<SpacePoint, 4> face = wall(85);
  face[0].up = face[2].up = Vec3();
  EXPECT_LT(scaled_jacobian_in_space(face), 0);
  face[1].up = face[3].up = Vec3();
  EXPECT_EQ(scaled_jacobian_in_space(face), 1);
}

TEST(FaceInSpace, HasTheWorstValueUpsideDown) {
  std::array<SpacePoint, 4> face = wall(0);
  for (SpacePoint& corner : face) corner.up = -1.0 * corner.up;
  EXPECT_EQ(scaled_jacobian_in_space(face), -1);
}

}  // namespace
}  // namespace quarry
