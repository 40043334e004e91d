// Straight segments in space.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

// The point of the closed segment from a to b nearest to p: a or b themselves at its ends.
[[nodiscard]] inline Vec3 closest_on_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const double squared = dot(d, d);
  if (!(squared > 0)) return a;
  const double t = dot(p - a, d) / squared;
  if (t <= 0) return a;
  return t >= 1 ? b : a + t * d;
}

// The squared distance of p from the closed segment.
[[nodiscard]] inline double squared_distance(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 d = closest_on_segment(p, a, b) - p;
  return dot(d, d);
}

// Where p lies along the line from a (0) to b (1), as the foot of its perpendicular; may lie outside [0, 1].
// 0 if a equals b.
[[nodiscard]] inline double projection_parameter(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const double squared = dot(d, d);
  return squared > 0 ? dot(p - a, d) / squared : 0;
}

}  // namespace quarry
