// Takes points out of the curves in which sheets meet, while the sheets are still one surface.
#pragma once

#include <cstdint>
#include <span>

#include "surface/repair/repair.hpp"

namespace quarry {

// Points that are not kept go into a neighbour along their join, the shortest edges first, with all triangles
// at them, as long as no triangle turns by more than 60 degrees and no point that was on the curve comes to
// lie farther than `deviation`, in input units, from the edge that takes its place. kept: by point; each one
// at which other than two joins meet, or which lies on a rim or on a border between groups, has to be.
// Leaves points that no triangle has. Returns the number of collapses.
std::uint64_t coarsen_joins(RepairedSurface& repaired, std::span<const std::uint8_t> kept, double deviation);

}  // namespace quarry
