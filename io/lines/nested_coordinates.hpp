// The nested lists of coordinates that GeoJSON and WKT have in common, kept flat until the geometry's type is
// known: in GeoJSON it may come later in the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Fed with the brackets and numbers of a list of positions, or of lists of them. Every function that can fail
// returns a description of what is wrong, empty if all is well; the caller knows the file and the feature.
class NestedCoordinates {
 public:
  void clear();

  [[nodiscard]] std::string start_array();
  [[nodiscard]] std::string end_array();
  [[nodiscard]] std::string number(double value);
  // True between the first start_array() and its end_array().
  [[nodiscard]] bool open() const { return !stack_.empty(); }
  [[nodiscard]] bool complete() const { return complete_; }

  // "position 3 (after (1, 2))": where the parser is, counted from 1 within this geometry.
  [[nodiscard]] std::string place() const;

  // Appends the lines or points of a geometry of this type; file and feature are stamped on them.
  [[nodiscard]] std::string append_geometry(std::string_view type, std::uint32_t file, std::uint32_t feature,
                                            LineSet& lines) const;

 private:
  enum class Holds { kNothing, kNumbers, kArrays };
  struct Array {
    Holds holds = Holds::kNothing;
    std::size_t first_point = 0;
    bool holds_positions = false;
  };
  // An array of positions, or an empty array.
  struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t depth = 0;    // 1: the outermost array
    std::size_t polygon = 0;  // how many arrays of depth 2 ended before
  };

  [[nodiscard]] std::string append_points(std::uint32_t file, std::uint32_t feature, LineSet& lines) const;

  std::vector<Array> stack_;
  std::vector<Vec2> points_;
  std::vector<double> heights_;  // not a number where there is none
  std::vector<Part> parts_;
  double axis_[3] = {0, 0, 0};
  std::size_t axis_count_ = 0;
  std::size_t polygons_ = 0;
  bool complete_ = false;
};

// Whether a type of geometry has "coordinates" at all.
[[nodiscard]] bool type_has_coordinates(std::string_view type);

}  // namespace quarry
