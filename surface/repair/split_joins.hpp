// Shortens the edges in which sheets meet, while the sheets are still one surface.
#pragma once

#include "surface/repair/repair.hpp"

namespace quarry {

// Halves joins until none is longer than that, with all triangles at them: the sheets, which are meshed apart
// from one another afterwards, then have the same points there. New points and triangles come last.
void split_joins(RepairedSurface& repaired, double longest);
// The same with each join, once: between any two points of before the sheets then have an even number.
void halve_joins(RepairedSurface& repaired);

}  // namespace quarry
