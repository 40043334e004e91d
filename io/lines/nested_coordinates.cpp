#include "io/lines/nested_coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/coordinate_limit.hpp"

namespace quarry {
namespace {

struct GeometryType {
  std::string_view name;
  std::size_t part_depth;  // depth of the arrays of positions; 0: points
  bool polygon;
};

constexpr std::array kTypes{
    GeometryType{"Point", 0, false},      GeometryType{"MultiPoint", 0, false},
    GeometryType{"LineString", 1, false}, GeometryType{"MultiLineString", 2, false},
    GeometryType{"Polygon", 2, true},     GeometryType{"MultiPolygon", 3, true},
};

const GeometryType* find_type(std::string_view name) {
  for (const GeometryType& type : kTypes)
    if (type.name == name) return &type;
  return nullptr;
}

}  // namespace

bool type_has_coordinates(std::string_view type) { return find_type(type) != nullptr; }

void NestedCoordinates::clear() {
  stack_.clear();
  points_.clear();
  heights_.clear();
  parts_.clear();
  axis_count_ = 0;
  polygons_ = 0;
  complete_ = false;
}

std::string NestedCoordinates::place() const {
  if (points_.empty()) return "position 1";
  const Vec2 last = points_.back();
  return fmt::format("position {} (after {})", points_.size() + 1, format_point(last.x, last.y));
}

std::string NestedCoordinates::start_array() {
  if (!stack_.empty()) {
    if (stack_.back().holds == Holds::kNumbers) return fmt::format("{}: an array among numbers", place());
    stack_.back().holds = Holds::kArrays;
  }
  Array opened;
  opened.first_point = points_.size();
  stack_.push_back(opened);
  axis_count_ = 0;
  return {};
}

std::string NestedCoordinates::number(double value) {
  if (stack_.back().holds == Holds::kArrays) return fmt::format("{}: a number among arrays", place());
  if (!is_usable_coordinate(value))
    return fmt::format("{}: coordinate {} is not a usable number; the largest is {:g}", place(), value,
                       kLargestCoordinate);
  stack_.back().holds = Holds::kNumbers;
  if (axis_count_ < 3) axis_[axis_count_] = value;
  ++axis_count_;
  return {};
}

std::string NestedCoordinates::end_array() {
  const Array closed = stack_.back();
  const std::size_t depth = stack_.size();
  stack_.pop_back();
  if (closed.holds == Holds::kNumbers) {
    if (axis_count_ < 2) return fmt::format("{}: a coordinate is missing; a position needs two", place());
    points_.push_back({axis_[0], axis_[1]});
    heights_.push_back(axis_count_ > 2 ? axis_[2] : std::numeric_limits<double>::quiet_NaN());
    if (!stack_.empty()) stack_.back().holds_positions = true;
  } else if (closed.holds_positions || closed.holds == Holds::kNothing) {
    if (closed.holds == Holds::kNothing && !stack_.empty() && stack_.back().holds_positions)
      return fmt::format("{}: a position without coordinates", place());
    parts_.push_back({closed.first_point, points_.size(), depth, polygons_});
  }
  if (depth == 2) ++polygons_;
  complete_ = stack_.empty();
  return {};
}

// A single position, or a list of them: well-known text has brackets around that of a Point as well.
std::string NestedCoordinates::append_points(std::uint32_t file, std::uint32_t feature,
                                             LineSet& lines) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    InputPoint point{points_[i]};
    if (!std::isnan(heights_[i])) point.height = heights_[i];
    point.file = file;
    point.feature = feature;
    lines.points.push_back(point);
  }
  return {};
}

std::string NestedCoordinates::append_geometry(std::string_view type, std::uint32_t file,
                                               std::uint32_t feature, LineSet& lines) const {
  const GeometryType* known = find_type(type);
  if (known == nullptr) return {};
  if (known->part_depth == 0) {
    for (const Part& part : parts_)
      if (part.depth > 1) return fmt::format("the coordinates of a {} are nested too deep", type);
    return append_points(file, feature, lines);
  }
  if (parts_.empty()) return fmt::format("the coordinates of a {} are a single position", type);
  std::size_t last_polygon = static_cast<std::size_t>(-1);
  for (const Part& part : parts_) {
    const std::size_t count = part.end - part.begin;
    if (count == 0 && part.depth < known->part_depth) continue;
    if (part.depth != known->part_depth)
      return fmt::format("the coordinates of a {} are nested {} deep instead of {}", type, part.depth + 1,
                         known->part_depth + 1);
    InputLine line;
    line.points.assign(points_.begin() + static_cast<std::ptrdiff_t>(part.begin),
                       points_.begin() + static_cast<std::ptrdiff_t>(part.end));
    const auto first_height = heights_.begin() + static_cast<std::ptrdiff_t>(part.begin);
    const auto last_height = heights_.begin() + static_cast<std::ptrdiff_t>(part.end);
    if (std::none_of(first_height, last_height, [](double z) { return std::isnan(z); }))
      line.heights.assign(first_height, last_height);
    if (count == 1)
      return fmt::format("a line of one point at {}; a line needs two points",
                         format_point(line.points[0].x, line.points[0].y));
    line.file = file;
    line.feature = feature;
    line.polygon_ring = known->polygon;
    // All rings of a Polygon belong to one polygon; those of a MultiPolygon lie in arrays of depth 2.
    const std::size_t polygon = known->part_depth == 3 ? part.polygon : 0;
    line.hole = known->polygon && polygon == last_polygon;
    last_polygon = polygon;
    if (known->polygon && count > 1 && !(line.points.front() == line.points.back())) {
      line.points.push_back(line.points.front());
      if (!line.heights.empty()) line.heights.push_back(line.heights.front());
    }
    lines.lines.push_back(std::move(line));
  }
  return {};
}

}  // namespace quarry
