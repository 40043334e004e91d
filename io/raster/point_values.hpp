// Reads points with a value each: text with a point a line.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct PointValue {
  Vec2 at;
  double value = 0;
};

// Lines of x, y and a value, parted by commas, semicolons or blanks; a first line of words is a heading, what
// follows a # is a comment. Throws Error(kInput), "path:line: ...", for what is no number or not finite, and
// for a file without points.
[[nodiscard]] std::vector<PointValue> read_point_values(const std::string& path);

}  // namespace quarry
