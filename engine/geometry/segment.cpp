#include "engine/geometry/segment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/geometry/predicates.hpp"

namespace quarry {
namespace {

// The order of points along any line that holds them.
bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

bool strictly_opposite(double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); }
bool strictly_same(double s, double t) { return (s > 0 && t > 0) || (s < 0 && t < 0); }

Meeting meeting_on_a_line(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto [a_low, a_high] = std::minmax(a, b, before);
  const auto [c_low, c_high] = std::minmax(c, d, before);
  const Vec2 low = std::max(a_low, c_low, before);
  const Vec2 high = std::min(a_high, c_high, before);
  if (before(high, low)) return Meeting::kApart;
  return low == high ? Meeting::kTouch : Meeting::kOverlap;
}

}  // namespace

double projection_parameter(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = squared_length(along);
  return squared > 0 ? dot(p - a, along) / squared : 0;
}

double closest_parameter(Vec2 p, Vec2 a, Vec2 b) {
  return std::clamp(projection_parameter(p, a, b), 0.0, 1.0);
}

Vec2 point_at(double t, Vec2 a, Vec2 b) { return t < 0.5 ? a + t * (b - a) : b + (1 - t) * (a - b); }

Vec2 closest_point(Vec2 p, Vec2 a, Vec2 b) { return point_at(closest_parameter(p, a, b), a, b); }

double squared_distance(Vec2 p, Vec2 a, Vec2 b) {
  const double t = projection_parameter(p, a, b);
  if (t <= 0) return squared_length(p - a);
  if (t >= 1) return squared_length(p - b);
  // The height of the triangle, which keeps its digits where the foot of the perpendicular would be rounded.
  const double twice_area = cross(b - a, p - a);
  return twice_area * twice_area / squared_length(b - a);
}

Meeting meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double c_side = orient2d(a, b, c);
  const double d_side = orient2d(a, b, d);
  if (strictly_same(c_side, d_side)) return Meeting::kApart;
  const double a_side = orient2d(c, d, a);
  const double b_side = orient2d(c, d, b);
  if (strictly_same(a_side, b_side)) return Meeting::kApart;
  if (c_side == 0 && d_side == 0 && a_side == 0 && b_side == 0) return meeting_on_a_line(a, b, c, d);
  const bool proper = strictly_opposite(c_side, d_side) && strictly_opposite(a_side, b_side);
  return proper ? Meeting::kProper : Meeting::kTouch;
}

bool on_segment(Vec2 p, Vec2 a, Vec2 b) { return meeting(p, p, a, b) != Meeting::kApart; }

Vec2 crossing_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (before(b, a)) std::swap(a, b);
  if (before(d, c)) std::swap(c, d);
  if (before(c, a) || (a == c && before(d, b))) {
    std::swap(a, c);
    std::swap(b, d);
  }
  // The signs of both are exact, so that the parameter of a proper crossing lies in [0, 1] whatever their
  // rounding.
  const double a_side = orient2d(c, d, a);
  const double b_side = orient2d(c, d, b);
  const double sum = a_side - b_side;
  return sum != 0 ? point_at(std::clamp(a_side / sum, 0.0, 1.0), a, b) : a;
}

double signed_angle(Vec2 u, Vec2 v) { return std::atan2(cross(u, v), dot(u, v)); }

double counterclockwise_angle(Vec2 u, Vec2 v) {
  const double angle = signed_angle(u, v);
  if (angle >= 0) return angle;
  const double turned = angle + 2 * std::numbers::pi;
  return turned < 2 * std::numbers::pi ? turned : 0;
}

}  // namespace quarry
