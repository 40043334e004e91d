#include "surface/project/float_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quarry {
namespace {

// Floats near this overflow when squared, which does no harm: they compare as too far or as infinite, which
// costs time alone. But the cast itself must not overflow.
constexpr double kLargestFloat = 3e38;

float to_float(double value) { return static_cast<float>(std::clamp(value, -kLargestFloat, kLargestFloat)); }

}  // namespace

FloatFrame::FloatFrame(const Box3& box) {
  const double side = box.longest_side();
  if (!(side >= 0)) return;  // no triangles
  center_ = box.low + 0.5 * (box.high - box.low);
  if (side > std::numeric_limits<double>::min()) scale_ = std::ldexp(1.0, -std::ilogb(side));
}

FloatPoint FloatFrame::rounded(Vec3 local) {
  return {to_float(local.x), to_float(local.y), to_float(local.z)};
}

double FloatFrame::slack(Vec3 local) {
  return 0x1p-20 * (1 + std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}));
}

float FloatFrame::covering_radius(double distance, double slack) const {
  const double radius = (distance * scale_ + slack) * (1 + 1e-6);
  return radius < kLargestFloat ? static_cast<float>(radius) : std::numeric_limits<float>::infinity();
}

}  // namespace quarry
