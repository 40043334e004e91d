// Keys along a Hilbert curve: points with near keys are near each other, so that arrays sorted by key (with
// parallel::sorted_order) keep neighbourhoods in the cache. Source of the transform: J. Skilling,
// "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004.
#pragma once

#include <cstdint>

#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

// Cells a side are 2 to this power. The keys of the plane then fill 56 bits, seven passes of the radix sort.
inline constexpr unsigned kHilbertOrder2 = 28;
inline constexpr unsigned kHilbertOrder3 = 21;

// The position along the curve of the cell that holds p, in the square (cube) that stands on the low corner
// of the box with its longest side. Points outside count as the nearest cell. The keys of neighbouring cells
// along the curve differ by one. A box of no extent gives 0.
[[nodiscard]] std::uint64_t hilbert_key(Vec2 p, const Box2& box);
[[nodiscard]] std::uint64_t hilbert_key(Vec3 p, const Box3& box);

}  // namespace quarry
