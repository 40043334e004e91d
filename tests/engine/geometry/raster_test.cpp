#include "engine/geometry/raster.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace quarry {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Three columns and two rows of cells of side 2, the lower left corner at (10, 20).
Raster sample() { return {3, 2, {10, 20}, 2, {1, 2, 3, 4, 5, 6}}; }

TEST(Raster, HasTheValuesOfItsCellsAtTheirCentres) {
  const Raster raster = sample();
  for (const double x : {11.0, 13.0, 15.0}) {
    EXPECT_EQ(raster.at({x, 23}), (x - 9) / 2) << "the first row is the upper one";
    EXPECT_EQ(raster.at({x, 21}), (x - 9) / 2 + 3);
  }
}

TEST(Raster, IsLinearBetweenCentres) {
  const Raster raster = sample();
  EXPECT_DOUBLE_EQ(*raster.at({12, 23}), 1.5);
  EXPECT_DOUBLE_EQ(*raster.at({11, 22}), 2.5);
  EXPECT_DOUBLE_EQ(*raster.at({12.5, 21.5}), 1 + 0.75 * 1 + 0.75 * 3);
}

TEST(Raster, EndsAtItsOutline) {
  const Raster raster = sample();
  EXPECT_EQ(raster.at({10, 20}), 4.0);
  EXPECT_EQ(raster.at({16, 24}), 3.0);
  EXPECT_DOUBLE_EQ(*raster.at({12, 24}), 1.5);
  for (const Vec2 outside :
       {Vec2{9.99, 21}, Vec2{16.01, 21}, Vec2{11, 19.99}, Vec2{11, 24.01}, Vec2{kNone, 21}})
    EXPECT_EQ(raster.at(outside), std::nullopt);
}

TEST(Raster, HasNoValueInCellsWithoutDataAndTakesNoneFromThem) {
  Raster raster = sample();
  raster.values[1] = kNone;
  EXPECT_EQ(raster.at({13, 23}), std::nullopt);
  EXPECT_EQ(raster.at({12.1, 22.5}), std::nullopt);
  EXPECT_DOUBLE_EQ(*raster.at({11.9, 23}), 1.0) << "the cell on the left goes on up to its side";
  EXPECT_DOUBLE_EQ(*raster.at({13, 21.9}), 5.0);
}

TEST(Raster, OfOneCellIsConstant) {
  const Raster raster{1, 1, {0, 0}, 10, {7}};
  EXPECT_EQ(raster.at({0, 0}), 7.0);
  EXPECT_EQ(raster.at({9, 1}), 7.0);
}

}  // namespace
}  // namespace quarry
