// Quality measures of one triangle or quad of the plane, as small inline functions of its corners in
// counter-clockwise order. None of them is a test of validity: that is exact and lies in
// engine/mesh/validate.hpp.
//
// Sources
//   [Verdict]  Stimpson, Ernst, Knupp, Pebay, Thompson: The Verdict Library Reference Manual, 2007 (scaled
//   Jacobian) [Lo]       Lo: A new mesh generation scheme for arbitrary planar domains, IJNME 21, 1985 (alpha
//   of a triangle) [LeeLo]    Lee, Lo: A new scheme for the generation of a graded quadrilateral mesh,
//   Comput. Struct. 52, 1994 (phi)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/geometry/vec.hpp"

namespace quarry {

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
inline constexpr double kSqrt3 = std::numbers::sqrt3;

// Twice the signed area of a triangle.
constexpr double doubled_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }
constexpr double signed_area(Vec2 a, Vec2 b, Vec2 c) { return 0.5 * doubled_area(a, b, c); }
// The area of a quad is half the cross product of its diagonals.
constexpr double signed_area(Vec2 a, Vec2 b, Vec2 c, Vec2 d) { return 0.5 * cross(c - a, d - b); }

// Sine of the angle from (here, next) to (here, previous), in [-1, 1]; -1 where an edge has no length, so
// that a degenerate corner never looks better than a bad one.
inline double corner_scaled_jacobian(Vec2 previous, Vec2 here, Vec2 next) {
  const Vec2 out = next - here;
  const Vec2 back = previous - here;
  const double lengths = std::sqrt(squared_length(out) * squared_length(back));
  return lengths > 0 ? cross(out, back) / lengths : -1.0;
}

// Smallest corner sine of a quad [Verdict]: 1 for a rectangle, not positive when inverted or not convex.
inline double scaled_jacobian(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::min(std::min(corner_scaled_jacobian(d, a, b), corner_scaled_jacobian(a, b, c)),
                  std::min(corner_scaled_jacobian(b, c, d), corner_scaled_jacobian(c, d, a)));
}

// Smallest corner sine of a triangle times 2/sqrt(3) [Verdict]: 1 for an equilateral one.
inline double scaled_jacobian(Vec2 a, Vec2 b, Vec2 c) {
  const double smallest = std::min(std::min(corner_scaled_jacobian(c, a, b), corner_scaled_jacobian(a, b, c)),
                                   corner_scaled_jacobian(b, c, a));
  return 2 / kSqrt3 * smallest;
}

// Inner angle at a corner in degrees, in [0, 360); more than 180 at a reflex corner.
inline double corner_angle(Vec2 previous, Vec2 here, Vec2 next) {
  const double angle =
      std::atan2(cross(next - here, previous - here), dot(next - here, previous - here)) * kDegreesPerRadian;
  return angle < 0 ? angle + 360.0 : angle;
}

// Smallest and largest inner angle in degrees.
struct AngleRange {
  double smallest;
  double largest;
};
inline AngleRange angle_range(Vec2 a, Vec2 b, Vec2 c) {
  const auto [low, high] = std::minmax({corner_angle(c, a, b), corner_angle(a, b, c), corner_angle(b, c, a)});
  return {low, high};
}
inline AngleRange angle_range(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto [low, high] = std::minmax(
      {corner_angle(d, a, b), corner_angle(a, b, c), corner_angle(b, c, d), corner_angle(c, d, a)});
  return {low, high};
}

// 4 sqrt(3) A / (l1^2 + l2^2 + l3^2) with the signed area A [Lo]: 1 for an equilateral triangle, 0 for a flat
// one or a point.
inline double lo_measure(Vec2 a, Vec2 b, Vec2 c) {
  const double squares = squared_length(b - a) + squared_length(c - b) + squared_length(a - c);
  return squares > 0 ? 2 * kSqrt3 * doubled_area(a, b, c) / squares : 0.0;
}

// The diagonals of a quad cut it into four triangles; with their Lo measures a1 >= a2 >= a3 >= a4 this is
// a3 a4 / (a1 a2) [LeeLo]: 1 for every rectangle whatever its aspect, 0.36 for a rhombus of 60 degrees,
// negative for a concave quad. The formula gives a bow-tie a positive value; here it gets its smallest
// triangle's measure instead.
inline double lee_lo_phi(std::array<double, 4> alpha) {
  const auto order = [&](std::size_t i, std::size_t j) {
    const double low = std::min(alpha[i], alpha[j]);
    alpha[j] = std::max(alpha[i], alpha[j]);
    alpha[i] = low;
  };
  // A sorting network of five exchanges.
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  if (!(alpha[1] > 0)) return alpha[0];
  return alpha[0] * alpha[1] / (alpha[2] * alpha[3]);
}
inline double lee_lo_phi(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return lee_lo_phi({lo_measure(a, b, c), lo_measure(a, c, d), lo_measure(b, c, d), lo_measure(a, b, d)});
}

// Shortest and longest edge, in the units of the coordinates.
struct EdgeRange {
  double shortest;
  double longest;
  // Longest by shortest edge: 1 at best, infinite with an edge of no length.
  [[nodiscard]] double ratio() const { return longest / shortest; }
};
inline EdgeRange edge_range(Vec2 a, Vec2 b, Vec2 c) {
  const auto [low, high] = std::minmax({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
  return {std::sqrt(low), std::sqrt(high)};
}
inline EdgeRange edge_range(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto [low, high] = std::minmax(
      {squared_length(b - a), squared_length(c - b), squared_length(d - c), squared_length(a - d)});
  return {std::sqrt(low), std::sqrt(high)};
}

// Longest by shortest edge ("aspect").
inline double edge_ratio(Vec2 a, Vec2 b, Vec2 c) { return edge_range(a, b, c).ratio(); }
inline double edge_ratio(Vec2 a, Vec2 b, Vec2 c, Vec2 d) { return edge_range(a, b, c, d).ratio(); }

}  // namespace quarry
