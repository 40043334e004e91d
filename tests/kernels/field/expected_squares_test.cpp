#include "kernels/field/expected_squares.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "kernels/field/graded_size.hpp"

namespace quarry {
namespace {

TEST(ExpectedSquares, AreTheAreaBySizeSquaredOfOneSize) {
  EXPECT_NEAR(expected_squares(UniformSize(0.5), {{0, 0}, {10, 20}}, 1e9), 800, 1e-6);
}

TEST(ExpectedSquares, CountWhatIsInsideAlone) {
  const auto left_half = [](Vec2 p) { return p.x < 5; };
  EXPECT_NEAR(expected_squares(UniformSize(0.5), {{0, 0}, {10, 20}}, 1e9, left_half), 400, 1e-6);
}

TEST(ExpectedSquares, AreNearTheIntegralOfAGradedField) {
  const GradedSize field({{{{0, 0}, {0, 0}}, 0.1}}, {.largest = 100, .gradation = 0.2});
  const Box2 box{{-30, -30}, {30, 30}};
  double sum = 0;
  constexpr double kStep = 0.02;
  for (double x = -30 + kStep / 2; x < 30; x += kStep)
    for (double y = -30 + kStep / 2; y < 30; y += kStep) {
      const double size = field.at({x, y});
      sum += kStep * kStep / (size * size);
    }
  EXPECT_NEAR(expected_squares(field, box, 1e9), sum, 0.1 * sum);
}

TEST(ExpectedSquares, StopSoonAfterTheMostAskedFor) {
  const double squares = expected_squares(UniformSize(1e-9), {{0, 0}, {1, 1}}, 1000);
  EXPECT_GT(squares, 1000);
  EXPECT_LT(squares, 2000);
}

TEST(ExpectedSquares, EndWhereDoublesCannotHalveABoxAnyMore) {
  const GradedSize field({{{{10, 10}, {10, 10}}, 1e-300}}, {.largest = 4, .gradation = 0.3});
  EXPECT_GT(expected_squares(field, {{0, 0}, {100, 60}}, 1e9), 375);
  EXPECT_GT(expected_squares(UniformSize(1e-20), {{1, 0}, {std::nextafter(1.0, 2.0), 1}}, 1e9), 0);
}

}  // namespace
}  // namespace quarry
