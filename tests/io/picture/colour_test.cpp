#include "io/picture/colour.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "io/picture/legend.hpp"

namespace quarry {
namespace {

double distance(Colour a, Colour b) { return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue); }

TEST(RegionColour, TellsRegionsInARowApart) {
  for (std::int32_t region = 0; region < 500; ++region)
    for (std::int32_t step = 1; step <= 3; ++step)
      EXPECT_GT(distance(region_colour(region), region_colour(region + step)), 0.04) << region << " " << step;
}

TEST(RegionColour, IsPale) {
  for (std::int32_t region = -1; region < 500; ++region) {
    const Colour c = region_colour(region);
    EXPECT_GT(std::min({c.red, c.green, c.blue}), 0.55) << region;
  }
}

TEST(QualityColour, IsBlackOnlyWhereQualityIsNotPositive) {
  EXPECT_EQ(distance(quality_colour(0), {0, 0, 0}), 0.0);
  EXPECT_EQ(distance(quality_colour(std::nan("")), {0, 0, 0}), 0.0);
  EXPECT_GT(distance(quality_colour(1e-6), {0, 0, 0}), 0.3);
}

TEST(QualityColour, GoesFromRedToBlueWithoutSteps) {
  EXPECT_GT(quality_colour(0.1).red, quality_colour(0.1).blue);
  EXPECT_LT(quality_colour(1.0).red, quality_colour(1.0).blue);
  for (int i = 1; i < 1000; ++i)
    EXPECT_LT(distance(quality_colour(0.001 * i), quality_colour(0.001 * (i + 1))), 0.01) << i;
}

TEST(Oklch, IsGreyWithoutChroma) {
  const Colour c = oklch(0.6, 0, 123);
  EXPECT_NEAR(c.red, c.green, 1e-6);
  EXPECT_NEAR(c.green, c.blue, 1e-6);
  EXPECT_NEAR(oklch(1, 0, 0).red, 1.0, 1e-6);
}

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_length(1), 1);
  EXPECT_DOUBLE_EQ(round_length(4.9), 2);
  EXPECT_DOUBLE_EQ(round_length(7300), 5000);
  EXPECT_DOUBLE_EQ(round_length(0.0199), 0.01);
}

TEST(GroupedDigits, AreInThrees) {
  EXPECT_EQ(grouped_digits(7), "7");
  EXPECT_EQ(grouped_digits(1234), "1,234");
  EXPECT_EQ(grouped_digits(1234567), "1,234,567");
}

}  // namespace
}  // namespace quarry
