// Divides the curves in which sheets meet, while the sheets are still one surface.
#pragma once

#include <cstdint>

#include "surface/feature/options.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

struct DivideJoinsOptions {
  // The wanted length of a join, in input units.
  double edge = 0;
  // No point of the curve as it was may lie farther from the edge that takes its place, in input units.
  double deviation = 0;
  // Which corners of the curves stay.
  FeatureOptions corners = {};
};

// Each chain of joins between two nodes or corners gets a whole number of parts of equal length along it,
// about the wanted one each: the sheets, which are meshed apart from one another afterwards, then have the
// same points there. Joins are cut at these points, with all triangles at them, and the points between them
// taken out as far as the curve and the triangles allow. Leaves points that no triangle has.
void divide_joins(RepairedSurface& repaired, const DivideJoinsOptions& options);
// Halves each join, once: between any two points of before the sheets then have an even number.
void halve_joins(RepairedSurface& repaired);

}  // namespace quarry
