// Lines from files of any format that is known.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "io/lines/ogr_reader.hpp"

namespace quarry {

// Reads the lines of all files; "-" is standard input. A line's number is its place in reading order across
// the files; each part of a MultiLineString and each ring of a polygon counts as one line, also if it has no
// points. The format follows from the extension, or from what is in the file (io/lines/line_format.hpp).
// Throws Error(kInput), one line with file, feature or row, and position, when a file cannot be read, is
// broken, holds a coordinate that is no finite number or a line of one point, and when no file holds a line.
[[nodiscard]] LineSet read_lines(const std::vector<std::string>& paths, const OgrOptions& options = {});

}  // namespace quarry
