// Whether points lie within a closed line, or near it, in about the time of looking at a few of its segments.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/predicates.hpp"

namespace quarry::linework {

// Whether a level ray from p to the left crosses the segment ab. A point at the height of an end counts as
// just above it, so that a ray through a vertex of a ring crosses it as often as one just above. Exact.
inline bool left_ray_crosses(Vec2 p, Vec2 a, Vec2 b) {
  if ((a.y <= p.y) == (b.y <= p.y)) return false;
  return a.y < b.y ? orient2d(a, b, p) < 0 : orient2d(b, a, p) < 0;
}

// Level strips over a range of heights, for finding what a level ray can meet.
class Rows {
 public:
  Rows(double low, double high, std::size_t count);

  void enter(std::uint32_t id, double from, double to);
  [[nodiscard]] const std::vector<std::uint32_t>& at(double height) const { return rows_[row(height)]; }

 private:
  [[nodiscard]] std::size_t row(double height) const;

  double low_;
  double height_;
  std::vector<std::vector<std::uint32_t>> rows_;
};

class RingLocator {
 public:
  // ring: its last point equals its first; must outlive the locator. near: the distance that near() is asked
  // about.
  RingLocator(std::span<const Vec2> ring, double near);
  // The grid views the segments, which stay where they are when moved, but not when copied.
  RingLocator(const RingLocator&) = delete;
  RingLocator(RingLocator&&) = default;

  // By the even-odd rule; for points on the ring either answer.
  [[nodiscard]] bool within(Vec2 p) const;
  [[nodiscard]] bool near(Vec2 p) const;
  // Within the ring or near it.
  [[nodiscard]] bool holds(Vec2 p) const { return box_.contains(p) && (within(p) || near(p)); }
  // The box of the ring, grown by `near`.
  [[nodiscard]] const Box2& box() const { return box_; }

 private:
  std::vector<Segment> segments_;
  double near_;
  Box2 box_;
  Rows rows_;
  SegmentGrid grid_;
};

}  // namespace quarry::linework
