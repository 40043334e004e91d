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

}  // namespace quarry
