// Lengthens the edges in which sheets meet, while the sheets are still one surface.
#pragma once

#include <cstdint>

#include "surface/repair/repair.hpp"

namespace quarry {

// Lengths are in input units.
struct CoarsenJoinsOptions {
  // Joins shorter than the first are collapsed along their curve, if no edge longer than the second comes of
  // it.
  double shortest = 0, longest = 0;
  // No point of the curve as it was may lie farther from the edge that takes its place.
  double deviation = 0;
};

// The shortest first, with all triangles at them, as long as no triangle turns by more than 60 degrees: the
// sheets, which are meshed apart from one another afterwards, then have the same points there. Points where
// other than two joins meet stay, and those at rims or on borders between groups. Leaves points that no
// triangle has. Returns the number of collapses.
std::uint64_t coarsen_joins(RepairedSurface& repaired, const CoarsenJoinsOptions& options);

}  // namespace quarry
