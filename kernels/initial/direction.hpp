// The direction that lines prefer, up to quarter turns: the way in which a lattice of squares is best turned.
#pragma once

#include "engine/geometry/line_set.hpp"

namespace quarry {

// The argument of the sum of length * exp(4 i angle) over the pieces that belong to an input line, divided by
// four: in degrees, in [-45, 45). 0 if the lines prefer no direction, or there is none.
[[nodiscard]] double dominant_direction(const NodedLines& lines);

}  // namespace quarry
