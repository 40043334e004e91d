#include "kernels/field/raster_size.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"

namespace quarry {
namespace {

// 20 by 10 cells of side 2 from (100, 50) on, all of this value.
Raster plain(double value) { return {20, 10, {100, 50}, 2, std::vector<double>(200, value)}; }

TEST(RasterSize, IsWhatTheRasterSaysWhereThatIsSmooth) {
  const RasterSize field(plain(3), {.largest = 5, .gradation = 0.3});
  EXPECT_DOUBLE_EQ(field.at({120, 60}), 3);
  EXPECT_DOUBLE_EQ(field.at({100, 50}), 3);
}

TEST(RasterSize, GrowsFromAFineCellByTheGradation) {
  Raster raster = plain(5);
  raster.values[5 * 20 + 10] = 0.5;  // the middle of this cell is (121, 59)
  const RasterSize field(std::move(raster), {.largest = 5, .gradation = 0.3});
  EXPECT_DOUBLE_EQ(field.at({121, 59}), 0.5);
  EXPECT_NEAR(field.at({127, 59}), 0.5 + 0.3 * 6, 1e-12);
  EXPECT_NEAR(field.at({125, 63}), 0.5 + 0.3 * std::hypot(4, 4), 1e-12);
  EXPECT_DOUBLE_EQ(field.at({101, 51}), 5);
}

TEST(RasterSize, IsHardlySteeperThanTheGradationAnywhere) {
  Raster raster = plain(5);
  for (std::size_t i = 0; i < raster.values.size(); ++i)
    if (uniform01(3, i) < 0.05) raster.values[i] = 0.2 + uniform01(4, i);
  const RasterSize field(std::move(raster), {.largest = 5, .gradation = 0.25});
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vec2 p{95 + 50 * uniform01(5, i), 45 + 30 * uniform01(6, i)};
    const Vec2 q = p + Vec2{uniform01(7, i) - 0.5, uniform01(8, i) - 0.5};
    // Bilinear between cells: up to the root of two along a diagonal.
    EXPECT_LE(std::abs(field.at(p) - field.at(q)), 0.25 * 1.4143 * distance(p, q) + 1e-12) << "number " << i;
  }
}

TEST(RasterSize, WantsTheLargestSizeWhereThereIsNoData) {
  Raster raster = plain(std::numeric_limits<double>::quiet_NaN());
  raster.values[0] = 4;
  const RasterSize field(std::move(raster), {.largest = 5, .gradation = 1});
  EXPECT_DOUBLE_EQ(field.at({130, 52}), 5);
  EXPECT_DOUBLE_EQ(field.at({1e6, 1e6}), 5);
}

TEST(RasterSize, RefusesSizesThatAreNotPositive) {
  Raster raster = plain(1);
  raster.values[25] = 0;
  EXPECT_THROW(RasterSize(raster, {.largest = 5}), Error);
  EXPECT_THROW(RasterSize(plain(1), {.largest = 5, .gradation = -1}), Error);
}

}  // namespace
}  // namespace quarry
