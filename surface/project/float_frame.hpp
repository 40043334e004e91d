// Coordinates in which floats are good enough to find candidates: about the middle of the surface, with half
// its longest side between 0.5 and 1. Boxes of floats stay tight in them at coordinates of 6.7e6, and nothing
// of an ordinary size overflows.
#pragma once

#include <array>

#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

using FloatPoint = std::array<float, 3>;

struct FloatBox {
  FloatPoint low{}, high{};
};

class FloatFrame {
 public:
  FloatFrame() = default;
  explicit FloatFrame(const Box3& box);

  [[nodiscard]] Vec3 local(Vec3 p) const { return scale_ * (p - center_); }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] static FloatPoint rounded(Vec3 local);

  // What must be added to a distance from a local point so that all rounding is covered: coordinates are off
  // by at most 2^-24 of their size, and distances reckoned with them by a few times that.
  [[nodiscard]] static double slack(Vec3 local);
  // A radius in local floats that covers a distance in input units.
  [[nodiscard]] float covering_radius(double distance, double slack) const;

  // How far a ray in local floats may pass by what the ray in double meets: its origin, its direction and the
  // sides of the boxes are all rounded, each by at most a few 2^-24. Boxes are that much wider.
  static constexpr double kRayMargin = 0x1p-18;

 private:
  Vec3 center_;
  double scale_ = 1;
};

}  // namespace quarry
