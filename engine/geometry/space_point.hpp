// A point of a surface in space together with the normal there: what kernels that run on surfaces move about.
// Sums and multiples act on both, so that a place between others gets a direction between theirs.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

struct SpacePoint {
  Vec3 place;
  Vec3 up;  // the normal; of any length where points have been added up

  friend constexpr SpacePoint operator+(SpacePoint a, SpacePoint b) {
    return {a.place + b.place, a.up + b.up};
  }
  friend constexpr SpacePoint operator-(SpacePoint a, SpacePoint b) {
    return {a.place - b.place, a.up - b.up};
  }
  friend constexpr SpacePoint operator*(double s, SpacePoint a) { return {s * a.place, s * a.up}; }
  friend constexpr bool operator==(SpacePoint, SpacePoint) = default;
};

// Of the places.
constexpr double dot(SpacePoint a, SpacePoint b) { return dot(a.place, b.place); }
constexpr Vec3 cross(SpacePoint a, SpacePoint b) { return cross(a.place, b.place); }

}  // namespace quarry
