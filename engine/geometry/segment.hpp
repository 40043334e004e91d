// Straight segments of the plane: nearest points, crossings and angles. Which way two segments meet is
// decided exactly; positions are computed relative to a point at hand and rounded once, so that large
// coordinates cost no more than their own rounding.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

// Where p lies along the line from a (0) to b (1), as the foot of its perpendicular; may lie outside [0, 1].
// 0 if a equals b.
[[nodiscard]] double projection_parameter(Vec2 p, Vec2 a, Vec2 b);

// The same for the nearest point of the closed segment: in [0, 1].
[[nodiscard]] double closest_parameter(Vec2 p, Vec2 a, Vec2 b);

// The point at parameter t, reckoned from the nearer end: exactly a at 0 and exactly b at 1.
[[nodiscard]] Vec2 point_at(double t, Vec2 a, Vec2 b);

// The point of the closed segment nearest to p.
[[nodiscard]] Vec2 closest_point(Vec2 p, Vec2 a, Vec2 b);

// The squared distance of p from the closed segment, accurate to a few roundings relative to the squared
// length of the segment and its distance, not to the coordinates.
[[nodiscard]] double squared_distance(Vec2 p, Vec2 a, Vec2 b);

// How two closed segments meet. Exact.
enum class Meeting {
  kApart,    // no common point
  kProper,   // one common point, inside both
  kTouch,    // one common point, an end of at least one of them
  kOverlap,  // on one line, with more than one common point
};

// How ab and cd meet. Segments of no length are points.
[[nodiscard]] Meeting meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

// Whether p lies on the closed segment ab. Exact.
[[nodiscard]] bool on_segment(Vec2 p, Vec2 a, Vec2 b);

// The point where ab and cd cross properly, rounded. It has the same bits for either order of the segments
// and of their ends; lies within their boxes up to rounding; and its distance from both is a few roundings of
// the larger of the coordinates and the lengths, also where they are nearly parallel. Where orientations
// cannot tell (parallel segments), a point of ab.
[[nodiscard]] Vec2 crossing_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

// The angle by which direction u must turn left to become v, in [-pi, pi] (radians). Its error is a few
// roundings, also near 0 and pi, where the arc cosine of a dot product has none of its digits left. 0 if one
// of them is zero.
[[nodiscard]] double signed_angle(Vec2 u, Vec2 v);

// The same in [0, 2 pi).
[[nodiscard]] double counterclockwise_angle(Vec2 u, Vec2 v);

}  // namespace quarry
