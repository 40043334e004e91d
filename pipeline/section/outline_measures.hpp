// Box, area and inside of an outline.
#pragma once

#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/grid.hpp"
#include "kernels/linework/outline.hpp"

namespace quarry {

[[nodiscard]] Box2 box_of(const Outline& outline);

// Of its polygons; those that overlap count twice, which is good enough to foresee a size.
[[nodiscard]] double area_of(const Outline& outline);

// Tells which places lie in the domain. Rounding may put a place within a few ulp of a ring on either side.
class InsideOutline {
 public:
  explicit InsideOutline(const Outline& outline);
  InsideOutline(const InsideOutline&) = delete;
  InsideOutline& operator=(const InsideOutline&) = delete;

  [[nodiscard]] bool operator()(Vec2 p) const;

 private:
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> polygons_;  // of each segment
  double right_;                         // beyond all rings
  SegmentGrid grid_;
};

}  // namespace quarry
