// Lines from files: the registry of readers by file name extension.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Reads the lines of all files. A line's number is its place in reading order across the files; each part of
// a MultiLineString and each ring of a polygon counts as one line, also if it has no points. Throws
// Error(kInput), one line with file, feature and position, when a file cannot be read, is broken, holds a
// coordinate that is no finite number or a line of one point, and when no file holds a line.
[[nodiscard]] LineSet read_lines(const std::vector<std::string>& paths);

}  // namespace quarry
