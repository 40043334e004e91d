// Planar straight-line graphs as Triangle reads and writes them (Shewchuk 1996): .poly, with .node beside it.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the longest chains of segments between vertices of other than two segments, or at which the marker
// changes; a marker other than 0 is the set of its line. Where there are holes, the smallest closed chain
// around a hole's point is a hole of the outline, and the outermost closed chains are polygons; a hole within
// no closed chain is told and meshed. Vertices come from the file of the same name with .node where the count
// in this one is 0. Errors name the row, and are as in read_lines.
void read_poly_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
