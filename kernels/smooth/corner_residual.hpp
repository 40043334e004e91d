// What squaring corners minimises: residuals of angles and of areas with their derivatives, for sweeps over
// single vertices and for steps of many at once.
#pragma once

namespace quarry {

// What is squared and summed up, and its derivative: by the angle of a corner, or by the area of a face.
template <class Real>
struct ResidualOf {
  Real value;
  Real slope;
};
using Residual = ResidualOf<double>;

// The wanted angle of a corner of a quad is 90 degrees, of a triangle 60.
template <class Real>
struct WantedAngleOf {
  Real cosine, sine;
};
template <class Real>
[[nodiscard]] constexpr WantedAngleOf<Real> wanted_angle(bool quad) {
  return quad ? WantedAngleOf<Real>{0, 1}
              : WantedAngleOf<Real>{static_cast<Real>(0.5), static_cast<Real>(0.86602540378443865)};
}

// tan((wanted - angle) / 2) of a corner, and its derivative by the angle as far as Gauss-Newton needs it.
// dot, cross: of the edges that leave the corner, the first and, counter-clockwise, the second; lengths: the
// product of their lengths.
template <class Real>
[[nodiscard]] constexpr ResidualOf<Real> angle_residual(Real dot, Real cross, Real lengths,
                                                        WantedAngleOf<Real> wanted) {
  const Real below = 1 / (lengths + wanted.cosine * dot + wanted.sine * cross);
  return {(wanted.sine * dot - wanted.cosine * cross) * below, -lengths * below};
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
