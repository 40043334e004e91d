// The second-order model of a function of a place in the plane, and the step to where it is smallest.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct Quadratic {
  double value = 0;
  Vec2 gradient;
  double xx = 0, xy = 0, yy = 0;  // second derivatives

  // Newton's step. Where the function curves down along an axis, the step goes downhill along it as far as if
  // it curved up as much.
  [[nodiscard]] Vec2 step() const {
    const double trace = xx + yy;
    const double determinant = xx * yy - xy * xy;
    if (trace > 0 && determinant > kFlat * trace * trace)
      return {-(yy * gradient.x - xy * gradient.y) / determinant,
              -(xx * gradient.y - xy * gradient.x) / determinant};
    return step_by_magnitudes();
  }

  // The same along a direction of length 1.
  [[nodiscard]] Vec2 step_along(Vec2 along) const {
    const double curvature =
        std::abs(xx * along.x * along.x + 2 * xy * along.x * along.y + yy * along.y * along.y);
    return curvature > 0 ? (-dot(gradient, along) / curvature) * along : Vec2{};
  }

 private:
  static constexpr double kFlat = 1e-4;

  [[nodiscard]] Vec2 step_by_magnitudes() const {
    const double mean = 0.5 * (xx + yy);
    const double half = 0.5 * (xx - yy);
    const double radius = std::sqrt(half * half + xy * xy);
    const double steep = std::max(std::abs(mean + radius), std::abs(mean - radius));
    if (!(steep > 0)) return {};
    const double first = std::max(std::abs(mean + radius), 0.01 * steep);
    const double second = std::max(std::abs(mean - radius), 0.01 * steep);
    // The axis of mean + radius, by the row of the matrix that cancels less.
    const Vec2 axis = half > 0 ? Vec2{half + radius, xy} : Vec2{xy, radius - half};
    const double squared = squared_length(axis);
    if (!(squared > 0)) return (-1 / steep) * gradient;
    const Vec2 across{-axis.y, axis.x};
    return (-dot(gradient, axis) / (squared * first)) * axis +
           (-dot(gradient, across) / (squared * second)) * across;
  }
};

}  // namespace quarry
