// Files of well-known text.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the lines of each geometry of a file; a geometry may take any number of rows, and ";" may follow
// it. Rows that start with # are comments. Errors name the row, and are as in read_lines.
void read_wkt_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
