// Opens forced merges. A triangle with one unconstrained side can be merged with one neighbour only; in a
// sharp wedge between constraints the third corner of that neighbour lies on the same straight line, so that
// the quad would have a straight corner whatever the matching does.
#pragma once

#include <cstdint>

#include "kernels/matching/join.hpp"

namespace quarry {

struct EarOptions {
  // A forced quad is opened if its corner at an end of the vanishing edge has a smaller sine and is obtuse.
  double smallest_sine = 0.1;
};

struct EarReport {
  std::uint64_t forced = 0;  // triangles with a single arc
  std::uint64_t bad = 0;     // whose only merge has a corner that is obtuse and flatter than asked, or reflex
  std::uint64_t opened = 0;
};

// Splits, for each bad forced merge, the unconstrained edge of the neighbour that is opposite the straight
// corner, at the place that makes the forced quad best. Two triangles become four, so that parities stay. The
// forced quad is then cut off by the new vertex and valid, and what remains has a choice. Merges whose edge
// to split is itself constrained stay as they are. In the plane and in space, where new vertices lie on the
// edges that they split.
void open_forced_ears(Mesh& mesh, ConstraintTags tags, const EarOptions& options, EarReport& report);

}  // namespace quarry
