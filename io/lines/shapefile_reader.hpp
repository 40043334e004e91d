// Shapefiles (ESRI 1998), by shapelib.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the lines of a Shapefile: polylines and polygons, with heights where it has them; points are passed
// over. Each part is a line. A polygon's rings come as outer rings (clockwise in the file) and the holes in
// them, each outer ring followed by its holes. Needs .shx beside it; takes attributes from .dbf and the
// coordinate system from .prj, where they are there. Errors name the feature, and are as in read_lines.
void read_shapefile_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
