// The point of one triangle that is nearest to a given one, in double. The nearest points of the three edges
// and the foot of the perpendicular are candidates, and the nearest of them wins: so a triangle of no area
// (a segment, a point) needs no case of its own, and one that is nearly so gives no worse an answer than its
// edges. Whatever depends on a corner or an edge alone has the same bits in every triangle that has it, if
// corners are given in an order of the whole surface (ascending coordinates): ties at edges are real ties.
#pragma once

#include <array>

#include "engine/geometry/vec.hpp"

namespace quarry {

using TriangleCorners = std::array<Vec3, 3>;
using CornerWeights = std::array<double, 3>;  // at least 0; their sum is 1 up to rounding

struct TrianglePoint {
  double squared_distance = 0;
  CornerWeights weights{};
};

// Reckoned from the corner with the greatest weight: exactly that corner where its weight is 1.
[[nodiscard]] inline Vec3 point_at(const CornerWeights& weights, const TriangleCorners& corners) {
  std::size_t base = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (weights[i] > weights[base]) base = i;
  const std::size_t next = (base + 1) % 3;
  const std::size_t last = (base + 2) % 3;
  return corners[base] +
         (weights[next] * (corners[next] - corners[base]) + weights[last] * (corners[last] - corners[base]));
}

namespace detail {

struct EdgePoint {
  double squared_distance;
  double parameter;  // 0 at a, 1 at b
};

// from_a, from_b: what leads from the ends to the point at hand.
inline EdgePoint closest_on_edge(Vec3 from_a, Vec3 from_b, Vec3 edge) {
  const double squared_edge = dot(edge, edge);
  const double along = dot(from_a, edge);
  const double parameter = along <= 0 ? 0 : along >= squared_edge ? 1 : along / squared_edge;
  const bool nearer_a = parameter <= 0.5;
  const Vec3 rest = (nearer_a ? from_a : from_b) - (nearer_a ? parameter : parameter - 1) * edge;
  return {dot(rest, rest), parameter};
}

}  // namespace detail

[[nodiscard]] inline TrianglePoint closest_on_triangle(Vec3 p, const TriangleCorners& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, bc = c - b;
  const Vec3 from_a = p - a, from_b = p - b, from_c = p - c;
  const detail::EdgePoint on_ab = detail::closest_on_edge(from_a, from_b, ab);
  const detail::EdgePoint on_ac = detail::closest_on_edge(from_a, from_c, ac);
  const detail::EdgePoint on_bc = detail::closest_on_edge(from_b, from_c, bc);
  TrianglePoint best{on_ab.squared_distance, {1 - on_ab.parameter, on_ab.parameter, 0}};
  if (on_ac.squared_distance < best.squared_distance)
    best = {on_ac.squared_distance, {1 - on_ac.parameter, 0, on_ac.parameter}};
  if (on_bc.squared_distance < best.squared_distance)
    best = {on_bc.squared_distance, {0, 1 - on_bc.parameter, on_bc.parameter}};
  // The areas that the foot of the perpendicular cuts off, times the area of the triangle. By cross products:
  // a Gram determinant would lose twice as many digits where the triangle is thin.
  const Vec3 normal = cross(ab, ac);
  const double whole = dot(normal, normal);
  const double of_b = dot(normal, cross(from_a, ac));
  const double of_c = dot(normal, cross(ab, from_a));
  if (!(of_b > 0 && of_c > 0 && of_b + of_c < whole)) return best;
  const double weight_b = of_b / whole, weight_c = of_c / whole;
  const Vec3 rest = from_a - (weight_b * ab + weight_c * ac);
  const double squared = dot(rest, rest);
  if (squared < best.squared_distance) best = {squared, {1 - weight_b - weight_c, weight_b, weight_c}};
  return best;
}

}  // namespace quarry
