// A triangulation of a simple or weakly simple polygon by its corners alone, chosen for its worst triangle.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry::deferred {

// Corners counter-clockwise, three or more; the base runs from the last to the first. Polygons of up to 160
// corners get the triangulation whose worst triangle by Lo's measure is best (dynamic programming over the
// sub-polygons of two corners, O(n^3)); larger ones that of the Delaunay rule (Anglada 1997), which is always
// valid too.
class PolygonPlan {
 public:
  explicit PolygonPlan(std::vector<Vec2> points);

  // Lo's measure of the worst triangle, not positive if the polygon has no triangulation; 0 for large
  // polygons.
  [[nodiscard]] double worst() const { return worst_; }

  // The corner that makes a triangle with the corners i and j, i < apex < j.
  [[nodiscard]] std::size_t apex(std::size_t i, std::size_t j) const;

 private:
  [[nodiscard]] double quality(std::size_t i, std::size_t k, std::size_t j) const;
  void find_best();

  std::vector<Vec2> points_;
  std::vector<std::size_t> apex_;
  double worst_ = 0;
};

}  // namespace quarry::deferred
