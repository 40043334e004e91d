// A point of a surface in space together with the normal there: what kernels that run on surfaces move about.
// Sums and multiples act on both, so that a place between others gets a direction between theirs.
#pragma once

#include <cstdint>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct SpacePoint {
  static constexpr std::uint32_t kNowhere = 0xffffffffU;

  Vec3 place;
  Vec3 up;  // the normal; of any length where points have been added up
  // Where on the surface it was found, as its model numbers it: the next search from here starts there, and
  // ends sooner. It changes no answer.
  std::uint32_t found_at = kNowhere;

  friend constexpr SpacePoint operator+(SpacePoint a, SpacePoint b) {
    return {a.place + b.place, a.up + b.up, a.found_at};
  }
  friend constexpr SpacePoint operator-(SpacePoint a, SpacePoint b) {
    return {a.place - b.place, a.up - b.up, a.found_at};
  }
  friend constexpr SpacePoint operator*(double s, SpacePoint a) {
    return {s * a.place, s * a.up, a.found_at};
  }
  friend constexpr bool operator==(SpacePoint a, SpacePoint b) { return a.place == b.place && a.up == b.up; }
};

// Of the places.
constexpr double dot(SpacePoint a, SpacePoint b) { return dot(a.place, b.place); }
constexpr Vec3 cross(SpacePoint a, SpacePoint b) { return cross(a.place, b.place); }

}  // namespace quarry
