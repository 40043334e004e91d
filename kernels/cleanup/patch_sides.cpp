#include "kernels/cleanup/patch_sides.hpp"

namespace quarry {

namespace {

template <class IsCorner>
PatchSides sides_between(std::size_t size, const IsCorner& is_corner) {
  PatchSides sides;
  for (std::size_t i = 0; i < size; ++i) {
    if (!is_corner(i)) continue;
    if (sides.count < kMostSides) sides.corners[sides.count] = static_cast<std::uint32_t>(i);
    ++sides.count;
  }
  if (sides.count == 0 || sides.count > kMostSides) return sides;
  for (std::uint32_t i = 0; i < sides.count; ++i) {
    const bool last = i + 1 == sides.count;
    const auto end = last ? sides.corners[0] + static_cast<std::uint32_t>(size) : sides.corners[i + 1];
    sides.lengths[i] = end - sides.corners[i];
  }
  return sides;
}

}  // namespace

PatchSides find_sides(const PatchGrowth& growth, std::span<const VertexId> rim, CornerRule rule) {
  return sides_between(rim.size(), [&](std::size_t i) {
    return rule == CornerRule::kOuterAngle ? growth.outer_angle(rim[i]) > 0 : growth.inside(rim[i]) == 1;
  });
}

PatchSides find_sides(const PatchRing& ring) {
  return sides_between(ring.size(), [&](std::size_t i) { return ring.targets[i] == 1; });
}

}  // namespace quarry
