#include "pipeline/section/vertical_plane.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"

namespace quarry {
namespace {

struct Plane {
  char axis = 'x';
  double value = 0;

  friend auto operator<=>(const Plane&, const Plane&) = default;
};

double along(Vec2 p, char axis) { return axis == 'x' ? p.x : p.y; }

bool stands_in(const InputLine& line, Plane plane) {
  return !line.heights.empty() &&
         std::ranges::all_of(line.points, [&](Vec2 p) { return along(p, plane.axis) == plane.value; });
}

// The plane in which a line stands, where it is not level.
std::optional<Plane> plane_of(const InputLine& line) {
  if (line.heights.empty() || std::ranges::minmax(line.heights).min == std::ranges::minmax(line.heights).max)
    return std::nullopt;
  for (const char axis : {'x', 'y'})
    if (const Plane plane{axis, along(line.points.front(), axis)}; stands_in(line, plane)) return plane;
  return std::nullopt;
}

// "x=314590 (18 lines), ...": the planes of most lines.
std::string list_planes(const LineSet& lines) {
  constexpr std::size_t kMost = 5;
  std::map<Plane, std::size_t> counts;
  for (const InputLine& line : lines.lines)
    if (const auto plane = plane_of(line)) ++counts[*plane];
  std::vector<std::pair<Plane, std::size_t>> planes(counts.begin(), counts.end());
  std::ranges::stable_sort(planes, std::greater<>(), &std::pair<Plane, std::size_t>::second);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(kMost, planes.size()); ++i)
    texts.push_back(fmt::format("{}={} ({} line{})", planes[i].first.axis, planes[i].first.value,
                                planes[i].second, planes[i].second == 1 ? "" : "s"));
  if (planes.size() > kMost) texts.push_back(fmt::format("{} more", planes.size() - kMost));
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

Plane parse(const std::string& text) {
  Plane plane;
  if (text.size() > 2 && (text[0] == 'x' || text[0] == 'y') && text[1] == '=') {
    plane.axis = text[0];
    if (const auto value = parse_finite(std::string_view(text).substr(2))) {
      plane.value = *value;
      return plane;
    }
  }
  throw Error(ErrorKind::kUsage, fmt::format("--section {}: give a plane as x=VALUE or y=VALUE", text));
}

std::string all_files(const LineSet& lines) { return fmt::format("{}", fmt::join(lines.files, ", ")); }

}  // namespace

void take_vertical_plane(LineSet& lines, const std::string& text) {
  const Plane plane = parse(text);
  IdVector<LineId, InputLine> kept;
  for (InputLine& line : lines.lines) {
    if (line.points.empty() || !stands_in(line, plane)) continue;
    for (std::size_t i = 0; i < line.points.size(); ++i)
      line.points[i] = {along(line.points[i], plane.axis == 'x' ? 'y' : 'x'), line.heights[i]};
    line.heights.clear();
    kept.push_back(std::move(line));
  }
  if (kept.empty())
    throw Error(ErrorKind::kInput,
                fmt::format("{}: no line stands in the plane {}={}; planes with lines: {}", all_files(lines),
                            plane.axis, plane.value, list_planes(lines)));
  lines.lines = std::move(kept);
  IdVector<PointId, InputPoint> points;
  for (InputPoint point : lines.points) {
    if (!point.height || along(point.place, plane.axis) != plane.value) continue;
    point.place = {along(point.place, plane.axis == 'x' ? 'y' : 'x'), *point.height};
    point.height.reset();
    points.push_back(point);
  }
  lines.points = std::move(points);
}

void refuse_vertical_planes(const LineSet& lines) {
  if (!lines.lines.empty() &&
      std::ranges::all_of(lines.lines, [](const InputLine& line) { return plane_of(line).has_value(); }))
    throw Error(ErrorKind::kInput,
                fmt::format("{}: all lines stand in vertical planes; choose one with --section: {}",
                            all_files(lines), list_planes(lines)));
}

}  // namespace quarry
