// Lines in space that stand in vertical planes: sections that were drawn where they belong.
#pragma once

#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Keeps the lines that stand in one plane, "x=VALUE" or "y=VALUE", and makes y (or x) and the height their
// coordinates. Lines are numbered anew. Throws Error(kUsage) for a text that names no plane, and
// Error(kInput) where no line stands in it; the message names planes in which some do.
void take_vertical_plane(LineSet& lines, const std::string& plane);

// Throws Error(kInput) where every line stands in such a plane: seen from above there is nothing to mesh. The
// message names the planes that hold most lines.
void refuse_vertical_planes(const LineSet& lines);

}  // namespace quarry
