// What --boundary says.
#pragma once

#include <string>

namespace quarry {

struct BoundaryRule {
  enum class Kind { kDefault, kHull, kBox, kFile };

  Kind kind = Kind::kDefault;
  // By how much the box is wider on each side, in input units, or as a share of the longer side of the lines'
  // box.
  double margin = 0;
  bool margin_is_share = false;
};

// "" is the default rule; "hull"; "box", "box:MARGIN" or "box:PERCENT%"; all else is the path of a file.
// Throws Error(kUsage) for a margin that is no number of 0 or more.
[[nodiscard]] BoundaryRule parse_boundary(const std::string& text);

}  // namespace quarry
