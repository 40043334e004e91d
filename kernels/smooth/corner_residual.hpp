// What squaring corners minimises: residuals of angles and of areas with their derivatives, for sweeps over
// single vertices and for steps of many at once.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

// What is squared and summed up, and its derivative: by the angle of a corner, or by the area of a face.
struct Residual {
  double value;
  double slope;
};

// The wanted angle of a corner of a quad is 90 degrees, of a triangle 60.
struct WantedAngle {
  double cosine, sine;
};
inline constexpr WantedAngle kRight{0, 1};
inline constexpr WantedAngle kSixty{0.5, 0.86602540378443865};

// tan((wanted - angle) / 2) of a corner, and its derivative by the angle as far as Gauss-Newton needs it. The
// angle runs from `out` to `back`, the edges that leave the corner; lengths: the product of their lengths.
inline Residual angle_residual(Vec2 out, Vec2 back, double lengths, WantedAngle wanted) {
  const double cosine = dot(out, back);
  const double sine = cross(out, back);
  const double below = 1.0 / (lengths + wanted.cosine * cosine + wanted.sine * sine);
  return {(wanted.sine * cosine - wanted.cosine * sine) * below, -lengths * below};
}

// What is asked of the area of a face, see corner_area in wanted_areas.hpp.
struct AreaDemand {
  double wanted, weight;
};

// weight * (a / w - w / a) / 2 of a face of area a where w is wanted, and its derivative by a: the logarithm
// of a / w where that is small, and steeper beyond.
inline Residual area_residual(double area, AreaDemand demand) {
  const double squared = demand.wanted * demand.wanted;
  const double scale = 0.5 * demand.weight / (area * demand.wanted);
  return {scale * (area * area - squared), scale * (area + squared / area)};
}

}  // namespace quarry
