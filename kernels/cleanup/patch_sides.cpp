#include "kernels/cleanup/patch_sides.hpp"

namespace quarry {

PatchSides find_sides(const PatchGrowth& growth, std::span<const VertexId> rim, CornerRule rule) {
  PatchSides sides;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const bool corner =
        rule == CornerRule::kOuterAngle ? growth.outer_angle(rim[i]) > 0 : growth.inside(rim[i]) == 1;
    if (!corner) continue;
    if (sides.count < kMostSides) sides.corners[sides.count] = static_cast<std::uint32_t>(i);
    ++sides.count;
  }
  if (sides.count == 0 || sides.count > kMostSides) return sides;
  for (std::uint32_t i = 0; i < sides.count; ++i) {
    const bool last = i + 1 == sides.count;
    const auto end = last ? sides.corners[0] + static_cast<std::uint32_t>(rim.size()) : sides.corners[i + 1];
    sides.lengths[i] = end - sides.corners[i];
  }
  return sides;
}

}  // namespace quarry
