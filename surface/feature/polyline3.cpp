#include "surface/feature/polyline3.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/geometry/space_segment.hpp"

namespace quarry {
namespace {

double outside(double value, double low, double high) { return std::max({low - value, value - high, 0.0}); }

}  // namespace

double Polyline3::Box::squared_distance(Vec3 p) const {
  const Vec3 d{outside(p.x, low.x, high.x), outside(p.y, low.y, high.y), outside(p.z, low.z, high.z)};
  return dot(d, d);
}

Polyline3::Polyline3(std::vector<Vec3> points) : points_(std::move(points)) {
  assert(points_.size() >= 2);
  const std::size_t segments = points_.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) length_ += quarry::length(points_[i + 1] - points_[i]);
  boxes_.resize(2 * std::bit_ceil(segments));
  build(1, 0, segments);
}

Polyline3::Box Polyline3::build(std::size_t node, std::size_t begin, std::size_t end) {
  Box& box = boxes_[node];
  if (end - begin == 1) {
    const Vec3 a = points_[begin];
    const Vec3 b = points_[end];
    box = {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
           {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
    return box;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const Box left = build(2 * node, begin, middle);
  const Box right = build(2 * node + 1, middle, end);
  box = {{std::min(left.low.x, right.low.x), std::min(left.low.y, right.low.y),
          std::min(left.low.z, right.low.z)},
         {std::max(left.high.x, right.high.x), std::max(left.high.y, right.high.y),
          std::max(left.high.z, right.high.z)}};
  return box;
}

Vec3 Polyline3::nearest(Vec3 p) const {
  Nearest best{points_.front(), std::numeric_limits<double>::infinity()};
  visit(1, 0, points_.size() - 1, p, best);
  return best.point;
}

// The nearer half first; the left one of equals, and an equal distance changes nothing: the first point wins.
void Polyline3::visit(std::size_t node, std::size_t begin, std::size_t end, Vec3 p, Nearest& best) const {
  if (end - begin == 1) {
    const Vec3 q = closest_on_segment(p, points_[begin], points_[end]);
    const double squared = dot(q - p, q - p);
    if (squared < best.squared) best = {q, squared};
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const double left = boxes_[2 * node].squared_distance(p);
  const double right = boxes_[2 * node + 1].squared_distance(p);
  if (left <= right && left < best.squared) visit(2 * node, begin, middle, p, best);
  if (right < best.squared) visit(2 * node + 1, middle, end, p, best);
  if (left > right && left < best.squared) visit(2 * node, begin, middle, p, best);
}

}  // namespace quarry
