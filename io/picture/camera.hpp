// From where a mesh in space is looked at, in parallel projection.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/geometry/vec.hpp"
#include "io/picture/picture.hpp"

namespace quarry {

class Camera {
 public:
  explicit Camera(const ViewDirection& view) {
    const double azimuth = view.azimuth * std::numbers::pi / 180;
    const double elevation = view.elevation * std::numbers::pi / 180;
    const double level = std::cos(elevation);
    towards_ = turned({level * std::cos(azimuth), level * std::sin(azimuth), std::sin(elevation)}, view.up);
    right_ = turned({-std::sin(azimuth), std::cos(azimuth), 0}, view.up);
    upwards_ = cross(towards_, right_);
  }

  // To the right, upwards, and towards the eye; in the units of the coordinates.
  [[nodiscard]] Vec3 seen(Vec3 p) const { return {dot(p, right_), dot(p, upwards_), dot(p, towards_)}; }

 private:
  // From a frame with z up into one with another axis up.
  static Vec3 turned(Vec3 p, UpAxis up) { return up == UpAxis::kZ ? p : Vec3{p.y, p.z, p.x}; }

  Vec3 right_, upwards_, towards_;
};

}  // namespace quarry
