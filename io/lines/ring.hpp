// Closed lines as areas.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

// Twice the area of a closed line, negative where it runs clockwise.
[[nodiscard]] inline double doubled_area(const std::vector<Vec2>& ring) {
  double area = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) area += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return area;
}

// Whether a closed line goes around a point: an odd number of crossings with the ray to the right of it.
[[nodiscard]] inline bool ring_holds(const std::vector<Vec2>& ring, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[i + 1];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

}  // namespace quarry
