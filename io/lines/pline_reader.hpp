// Polylines of GOCAD files (.pl).
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the lines of each PLine of a file: the runs of segments (SEG) of each ILINE that go on from one
// another, or its points in order where it has no segments. z is the height, also where ZPOSITIVE is Depth;
// the name of the object is that of its lines. Objects of other sorts are passed over. Errors name the row,
// and are as in read_lines.
void read_pline_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
