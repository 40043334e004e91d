// The point of one triangle that is nearest to a given one, in double. The nearest points of the three edges
// and the foot of the perpendicular are candidates, and the nearest of them wins: so a triangle of no area
// (a segment, a point) needs no case of its own, and one that is nearly so gives no worse an answer than its
// edges. Whatever depends on a corner or an edge alone has the same bits in every triangle that has it, if
// corners are given in an order of the whole surface (ascending coordinates): ties at edges are real ties.
#pragma once

#include <array>
#include <cstddef>

#include "engine/geometry/vec.hpp"
#include "surface/project/lanes.hpp"

namespace quarry {

using TriangleCorners = std::array<Vec3, 3>;
using CornerWeights = std::array<double, 3>;  // at least 0; their sum is 1 up to rounding

// For one triangle (Real is double) or for one a lane.
template <class Real>
struct TrianglePoint {
  Real squared_distance;
  std::array<Real, 3> weights;
};

template <class Real>
struct EdgePoint {
  Real squared_distance;
  Real parameter;  // 0 at the first end, 1 at the second
};

// from_a, from_b: what leads from the ends to the point at hand. Reckoned from the nearer end. Without
// branches, as all below: which candidate wins is hard to foresee.
template <class Real>
EdgePoint<Real> closest_on_edge(const LaneVec3<Real>& from_a, const LaneVec3<Real>& from_b,
                                const LaneVec3<Real>& edge) {
  const Real zero{}, one = zero + 1.0;
  const Real squared_edge = dot(edge, edge);
  const Real along = dot(from_a, edge);
  const Real to_the_right = along >= squared_edge ? one : along / squared_edge;
  const Real parameter = along > zero ? to_the_right : zero;
  const auto nearer_a = parameter <= 0.5;
  const Real from_nearer = nearer_a ? parameter : parameter - one;
  const LaneVec3<Real> rest = choose(nearer_a, from_a, from_b) - from_nearer * edge;
  return {dot(rest, rest), parameter};
}

// Inlined always, so that who wants no weights pays for none.
template <class Real>
[[gnu::always_inline]] inline TrianglePoint<Real> closest_on_triangle(
    const LaneVec3<Real>& p, const std::array<LaneVec3<Real>, 3>& corners) {
  const Real zero{}, one = zero + 1.0;
  const auto& [a, b, c] = corners;
  const LaneVec3<Real> ab = b - a, ac = c - a, bc = c - b;
  const LaneVec3<Real> from_a = p - a, from_b = p - b, from_c = p - c;
  const EdgePoint<Real> on_ab = closest_on_edge(from_a, from_b, ab);
  const EdgePoint<Real> on_ac = closest_on_edge(from_a, from_c, ac);
  const EdgePoint<Real> on_bc = closest_on_edge(from_b, from_c, bc);
  Real best = on_ab.squared_distance;
  LaneVec3<Real> weights{one - on_ab.parameter, on_ab.parameter, zero};
  const auto by_ac = on_ac.squared_distance < best;
  best = by_ac ? on_ac.squared_distance : best;
  weights = choose(by_ac, LaneVec3<Real>{one - on_ac.parameter, zero, on_ac.parameter}, weights);
  const auto by_bc = on_bc.squared_distance < best;
  best = by_bc ? on_bc.squared_distance : best;
  weights = choose(by_bc, LaneVec3<Real>{zero, one - on_bc.parameter, on_bc.parameter}, weights);
  // The areas that the foot of the perpendicular cuts off, times the area of the triangle. By cross products:
  // a Gram determinant would lose twice as many digits where the triangle is thin.
  const LaneVec3<Real> normal = cross(ab, ac);
  const Real whole = dot(normal, normal);
  const Real of_b = dot(normal, cross(from_a, ac));
  const Real of_c = dot(normal, cross(ab, from_a));
  const Real weight_b = of_b / whole, weight_c = of_c / whole;
  const LaneVec3<Real> rest = from_a - (weight_b * ab + weight_c * ac);
  const Real squared = dot(rest, rest);
  const auto inside = (of_b > zero) & (of_c > zero) & (of_b + of_c < whole) & (squared < best);
  weights = choose(inside, LaneVec3<Real>{one - weight_b - weight_c, weight_b, weight_c}, weights);
  return {inside ? squared : best, {weights.x, weights.y, weights.z}};
}

[[nodiscard]] inline TrianglePoint<double> closest_on_triangle(Vec3 p, const TriangleCorners& corners) {
  const auto lane = [](Vec3 v) { return LaneVec3<double>{v.x, v.y, v.z}; };
  return closest_on_triangle<double>(lane(p), {lane(corners[0]), lane(corners[1]), lane(corners[2])});
}

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

}  // namespace quarry
