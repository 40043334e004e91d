#include "kernels/quality/element.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "kernels/quality/face_measures.hpp"

namespace quarry {
namespace {

constexpr Vec2 kOrigin{0, 0};
const double kHalfSqrt3 = std::sqrt(0.75);

TEST(ScaledJacobian, IsOneForRectanglesAndEquilateralTriangles) {
  EXPECT_DOUBLE_EQ(scaled_jacobian(kOrigin, {4, 0}, {4, 1}, {0, 1}), 1.0);
  EXPECT_DOUBLE_EQ(scaled_jacobian(kOrigin, {1, 0}, {0.5, kHalfSqrt3}), 1.0);
}

TEST(ScaledJacobian, IsTheSineOfTheSmallestCorner) {
  EXPECT_NEAR(scaled_jacobian(kOrigin, {1, 0}, {1.5, kHalfSqrt3}, {0.5, kHalfSqrt3}), kHalfSqrt3, 1e-15);
}

TEST(ScaledJacobian, IsNotPositiveForConcaveBowTieAndInvertedQuads) {
  EXPECT_LT(scaled_jacobian(kOrigin, {2, 0}, {0.5, 0.5}, {0, 2}), 0.0);
  EXPECT_LT(scaled_jacobian(kOrigin, {1, 0}, {0, 1}, {1, 1}), 0.0);
  EXPECT_DOUBLE_EQ(scaled_jacobian(kOrigin, {0, 1}, {1, 1}, {1, 0}), -1.0);
}

TEST(ScaledJacobian, IsMinusOneWhereAnEdgeHasNoLength) {
  EXPECT_DOUBLE_EQ(scaled_jacobian(kOrigin, kOrigin, {1, 1}, {0, 1}), -1.0);
}

TEST(LoMeasure, IsOneForEquilateralZeroForFlatAndNegativeForInvertedTriangles) {
  EXPECT_NEAR(lo_measure(kOrigin, {1, 0}, {0.5, kHalfSqrt3}), 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(lo_measure(kOrigin, {1, 0}, {2, 0}), 0.0);
  EXPECT_NEAR(lo_measure(kOrigin, {0.5, kHalfSqrt3}, {1, 0}), -1.0, 1e-15);
  EXPECT_DOUBLE_EQ(lo_measure(kOrigin, kOrigin, kOrigin), 0.0);
}

TEST(LeeLoPhi, HasTheValuesOfKnownQuads) {
  EXPECT_NEAR(lee_lo_phi(kOrigin, {1, 0}, {1, 1}, {0, 1}), 1.0, 1e-15);
  EXPECT_NEAR(lee_lo_phi(kOrigin, {4, 0}, {4, 1}, {0, 1}), 1.0, 1e-15);
  EXPECT_NEAR(lee_lo_phi(kOrigin, {1, 0}, {1.5, kHalfSqrt3}, {0.5, kHalfSqrt3}), 0.36, 1e-12);
  EXPECT_LT(lee_lo_phi(kOrigin, {2, 0}, {0.5, 0.5}, {0, 2}), 0.0);
}

TEST(LeeLoPhi, IsNegativeForABowTie) { EXPECT_LT(lee_lo_phi(kOrigin, {1, 0}, {0, 1}, {1, 1}), 0.0); }

TEST(CornerAngle, IsTheInnerAngleInDegrees) {
  EXPECT_DOUBLE_EQ(corner_angle({0, 1}, kOrigin, {1, 0}), 90.0);
  EXPECT_DOUBLE_EQ(corner_angle({1, 0}, kOrigin, {0, 1}), 270.0);
  EXPECT_DOUBLE_EQ(corner_angle({1, 1}, kOrigin, {1, 0}), 45.0);
}

TEST(AngleRange, HoldsTheSmallestAndTheLargestAngle) {
  const auto [smallest, largest] = angle_range(kOrigin, {1, 0}, {1.5, kHalfSqrt3}, {0.5, kHalfSqrt3});
  EXPECT_NEAR(smallest, 60.0, 1e-12);
  EXPECT_NEAR(largest, 120.0, 1e-12);
}

TEST(EdgeRatio, IsLongestByShortestEdge) {
  EXPECT_DOUBLE_EQ(edge_ratio(kOrigin, {4, 0}, {4, 1}, {0, 1}), 4.0);
  EXPECT_DOUBLE_EQ(edge_ratio(kOrigin, {3, 0}, {3, 4}), 5.0 / 3.0);
}

TEST(SignedArea, OfAQuadIsThatOfItsTwoTriangles) {
  const Vec2 b{3, -0.5}, c{2.5, 2}, d{-0.25, 1.75};
  EXPECT_DOUBLE_EQ(signed_area(kOrigin, b, c, d), signed_area(kOrigin, b, c) + signed_area(kOrigin, c, d));
}

Vec2 random_point(std::uint64_t counter) {
  return {4 * uniform01(5, 2 * counter), 4 * uniform01(5, 2 * counter + 1)};
}

TEST(FaceMeasures, AreThoseOfTheSingleFunctions) {
  for (std::uint64_t i = 0; i < 4000; i += 4) {
    const Vec2 a = random_point(i), b = random_point(i + 1), c = random_point(i + 2), d = random_point(i + 3);
    const FaceMeasures quad = face_measures(a, b, c, d);
    EXPECT_DOUBLE_EQ(quad.scaled_jacobian, scaled_jacobian(a, b, c, d));
    EXPECT_DOUBLE_EQ(quad.angles.smallest, angle_range(a, b, c, d).smallest);
    EXPECT_DOUBLE_EQ(quad.angles.largest, angle_range(a, b, c, d).largest);
    EXPECT_NEAR(quad.lo, lee_lo_phi(a, b, c, d), 1e-12 * std::max(1.0, std::abs(quad.lo)));
    EXPECT_DOUBLE_EQ(quad.edges.ratio(), edge_ratio(a, b, c, d));
    const FaceMeasures triangle = face_measures(a, b, c);
    EXPECT_DOUBLE_EQ(triangle.scaled_jacobian, scaled_jacobian(a, b, c));
    EXPECT_DOUBLE_EQ(triangle.angles.smallest, angle_range(a, b, c).smallest);
    EXPECT_DOUBLE_EQ(triangle.angles.largest, angle_range(a, b, c).largest);
    EXPECT_NEAR(triangle.lo, lo_measure(a, b, c), 1e-12);
    EXPECT_DOUBLE_EQ(triangle.edges.ratio(), edge_ratio(a, b, c));
  }
}

}  // namespace
}  // namespace quarry
