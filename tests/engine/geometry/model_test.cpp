#include "engine/geometry/model.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace quarry {
namespace {

struct ModelWithoutNormal {
  using Point = Vec2;
  [[nodiscard]] Vec2 project(Vec2 p) const { return p; }
  [[nodiscard]] double orientation(Vec2, Vec2, Vec2) const { return 0; }
};
static_assert(!GeometryModel<ModelWithoutNormal>);
static_assert(!GeometryModel<int>);

TEST(PlaneModel, LeavesPointsWhereTheyAre) {
  const Vec2 p{6.7e6 + 1e-9, -0.0};
  EXPECT_EQ(PlaneModel().project(p), p);
  EXPECT_EQ(PlaneModel().normal(p), (Vec3{0, 0, 1}));
}

TEST(PlaneModel, OrientsExactly) {
  const Vec2 a{0.1, 0.1};
  const Vec2 b{0.7, 0.7};
  EXPECT_EQ(PlaneModel().orientation(a, b, {0.3, 0.3}), 0);
  EXPECT_GT(PlaneModel().orientation(a, b, {0.3, std::nextafter(0.3, 1)}), 0);
  EXPECT_LT(PlaneModel().orientation(a, b, {std::nextafter(0.3, 1), 0.3}), 0);
}

}  // namespace
}  // namespace quarry
