#include "pipeline/section/wanted_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"
#include "io/raster/point_values.hpp"
#include "io/raster/raster_file.hpp"
#include "kernels/field/expected_squares.hpp"
#include "kernels/field/gap_sizes.hpp"
#include "kernels/field/raster_size.hpp"

namespace quarry {
namespace {

constexpr double kSmallestShare = 0.1;
// Of what coordinates of this magnitude are told apart by: corners of smaller elements fall together.
constexpr double kUnitsOfTheSmallest = 1000;
// More are not counted to find a factor: a field of so many different places has no use.
constexpr double kMostSquares = 1e9;
constexpr std::string_view kAllLines = "lines";

// files: what the groups of files are called, by their number.
bool belongs_to(const LineSet& set, LineId id, const std::string& group,
                const std::vector<std::string>& files) {
  const LineAttributes attributes = set.attributes_of(id);
  return group == kAllLines || group == attributes.set || group == attributes.name ||
         group == attributes.material || group == files[set.lines[id].file];
}

std::shared_ptr<const SizeField> near_field(const NearGroup& near, const LineSet& lines,
                                            const std::vector<std::string>& files,
                                            const GradedSizeOptions& grading) {
  std::vector<SizeSource> sources;
  for (const LineId id : IdRange<LineId>(lines.lines.size())) {
    if (!belongs_to(lines, id, near.group, files)) continue;
    const std::vector<Vec2>& points = lines.lines[id].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      sources.push_back({{points[i], points[i + 1]}, near.size, near.distance});
  }
  if (sources.empty())
    throw Error(ErrorKind::kUsage, fmt::format("--refine-near {}: no line is of this group: give \"{}\", a "
                                               "file by its name without ending, or a set, "
                                               "name or material of lines",
                                               near.group, kAllLines));
  return std::make_shared<GradedSize>(std::move(sources), grading);
}

std::shared_ptr<const SizeField> file_field(const std::string& path, const GradedSizeOptions& grading) {
  try {
    if (is_raster_file(path)) return std::make_shared<RasterSize>(read_raster(path), grading);
    std::vector<SizeSource> sources;
    for (const PointValue& point : read_point_values(path))
      sources.push_back({{point.at, point.at}, point.value});
    return std::make_shared<GradedSize>(std::move(sources), grading);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kInput) throw;
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", path, error.message()));
  }
}

// Elements below it cannot be told apart where the lines lie.
double least_size(const LineSet& lines) {
  const Box2 box = lines.box();
  const double magnitude =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return kUnitsOfTheSmallest * std::numeric_limits<double>::epsilon() * magnitude;
}

// The size below which none is wanted.
double smallest_size(const SizeOptions& options, const LineSet& lines, double largest) {
  const double least = least_size(lines);
  if (!options.smallest) return std::min(std::max(kSmallestShare * largest, least), largest);
  const double smallest = *options.smallest;
  if (!(smallest > 0 && smallest <= largest))
    throw Error(ErrorKind::kUsage,
                fmt::format("--smallest is {}: it must be above 0, and at most the largest size {:.6g}",
                            smallest, largest));
  if (smallest < least)
    throw Error(ErrorKind::kUsage,
                fmt::format("--smallest is {}: coordinates as large as those of the lines tell nothing apart "
                            "below {}; give at least that",
                            smallest, least));
  return smallest;
}

}  // namespace

NearGroup parse_near_group(const std::string& text) {
  const std::size_t second = text.rfind(':');
  const std::size_t first = second == std::string::npos || second == 0 ? second : text.rfind(':', second - 1);
  if (first != std::string::npos && first < second && first > 0) {
    const auto size = parse_finite(std::string_view(text).substr(first + 1, second - first - 1));
    const auto distance = parse_finite(std::string_view(text).substr(second + 1));
    if (size && *size > 0 && distance && *distance >= 0) return {text.substr(0, first), *size, *distance};
  }
  throw Error(
      ErrorKind::kUsage,
      fmt::format(
          "--refine-near {}: give it as GROUP:SIZE:DISTANCE with a size above 0 and a distance of 0 or "
          "more",
          text));
}

WantedSizes::WantedSizes(const SizeOptions& options, const LineSet& lines,
                         const std::vector<std::string>& files, double largest)
    : options_(options), largest_(largest), smallest_(smallest_size(options, lines, largest)) {
  asked_.push_back(std::make_shared<UniformSize>(largest_));
  if (!options.file.empty()) asked_.push_back(file_field(options.file, grading()));
  for (const std::string& text : options.near)
    asked_.push_back(near_field(parse_near_group(text), lines, files, grading()));
  rescale(1);
}

void WantedSizes::set_gaps(const NodedLines& lines) {
  if (!options_.between) return;
  if (!(*options_.between > 0) || !std::isfinite(*options_.between))
    throw Error(ErrorKind::kUsage,
                fmt::format("--between-lines is {}: it must be above 0", *options_.between));
  const GapOptions gaps{*options_.between, smallest_, largest_};
  gaps_ = std::make_shared<GradedSize>(gap_sizes(lines, gaps), grading());
  rescale(factor_);
}

void WantedSizes::fit(double count, const Box2& box, const std::function<bool(Vec2)>& inside) {
  rescale(1);
  rescale(std::sqrt(expected_squares(field(), box, kMostSquares, inside) / count));
}

double WantedSizes::count_squares(const Box2& box, double most) const {
  return expected_squares(field(), box, most);
}

double WantedSizes::smallest_on(const LineSet& lines) const {
  double size = largest();
  for (const InputLine& line : lines.lines)
    for (const Vec2 p : line.points) size = std::min(size, field().at(p));
  return size;
}

void WantedSizes::rescale(double factor) {
  factor_ = factor;
  std::vector<std::shared_ptr<const SizeField>> fields = asked_;
  if (gaps_) fields.push_back(gaps_);
  sizes_ = std::make_unique<const SmallestSize>(std::move(fields));
  scaled_ = std::make_unique<const ScaledSize>(*sizes_, factor, factor * smallest_);
}

}  // namespace quarry
