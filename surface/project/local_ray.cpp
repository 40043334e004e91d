#include "surface/project/local_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quarry {
namespace {

// Wider than the boxes of the triangles.
constexpr double kMargin = 2 * FloatFrame::kRayMargin;

struct Span {
  double begin, end;
};

// The part of a span along the ray that lies between two planes across one axis.
Span between(Span span, double origin, double direction, double low, double high) {
  if (direction == 0) return low <= origin && origin <= high ? span : Span{1, 0};
  const double first = ((direction > 0 ? low : high) - origin) / direction;
  const double last = ((direction > 0 ? high : low) - origin) / direction;
  return {std::max(span.begin, first), std::min(span.end, last)};
}

}  // namespace

LocalRay::LocalRay(const Box3& box, const FloatFrame& frame, Vec3 origin, Vec3 direction) {
  if (!(box.low.x <= box.high.x)) return;  // no triangles
  origin_ = frame.local(origin);
  // Scaled twice, so that neither a tiny nor a huge direction is lost in squaring it.
  const double size = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  direction_ = (1 / size) * direction;
  const double rest = quarry::length(direction_);
  direction_ = (1 / rest) * direction_;
  unit_ = size * rest * frame.scale();
  const Vec3 margin{kMargin, kMargin, kMargin};
  const Vec3 low = frame.local(box.low) - margin;
  const Vec3 high = frame.local(box.high) + margin;
  Span inside{0, std::numeric_limits<double>::infinity()};
  inside = between(inside, origin_.x, direction_.x, low.x, high.x);
  inside = between(inside, origin_.y, direction_.y, low.y, high.y);
  inside = between(inside, origin_.z, direction_.z, low.z, high.z);
  entry_ = inside.begin;
  exit_ = inside.end;
}

float LocalRay::covering_length(double end) const {
  return static_cast<float>((end - entry_ + FloatFrame::kRayMargin) * (1 + 1e-6));
}

}  // namespace quarry
