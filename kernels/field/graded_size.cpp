#include "kernels/field/graded_size.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"

namespace quarry {
namespace {

void require_positive(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value))
    throw Error(ErrorKind::kUsage, fmt::format("{} is {}: it must be positive", what, value));
}

double smallest_of(const std::vector<SizeSource>& sources, const GradedSizeOptions& options) {
  require_grading(options);
  double smallest = options.largest;
  for (const SizeSource& source : sources) {
    require_positive(source.size, "the size at a source");
    if (!(source.reach >= 0) || !std::isfinite(source.reach))
      throw Error(ErrorKind::kUsage,
                  fmt::format("the reach of a size is {}: it must be 0 or more", source.reach));
    smallest = std::min(smallest, source.size);
  }
  return smallest;
}

double longest_reach(const std::vector<SizeSource>& sources) {
  double longest = 0;
  for (const SizeSource& source : sources) longest = std::max(longest, source.reach);
  return longest;
}

std::vector<Segment> segments_of(const std::vector<SizeSource>& sources) {
  std::vector<Segment> segments;
  segments.reserve(sources.size());
  for (const SizeSource& source : sources) segments.push_back(source.segment);
  return segments;
}

}  // namespace

void require_grading(const GradedSizeOptions& options) {
  require_positive(options.largest, "the largest size");
  require_positive(options.gradation, "the gradation of sizes");
}

GradedSize::GradedSize(std::vector<SizeSource> sources, const GradedSizeOptions& options)
    : sources_(std::move(sources)),
      segments_(segments_of(sources_)),
      options_(options),
      smallest_(smallest_of(sources_, options)),
      reach_(longest_reach(sources_)),
      grid_(segments_, options.largest) {}

double GradedSize::at(Vec2 p) const {
  double size = options_.largest;
  if (sources_.empty()) return size;
  // Sources farther than a radius cannot be felt once the size found is no more than the least that they
  // could ask for.
  std::vector<std::uint32_t> ids;
  for (double radius = smallest_;; radius *= 2) {
    grid_.find(Box2{p, p}.grown(reach_ + radius), ids);
    for (const std::uint32_t id : ids) {
      const auto& [segment, wanted, reach] = sources_[id];
      const double away = std::sqrt(squared_distance(p, segment.from, segment.to));
      size = std::min(size, wanted + options_.gradation * std::max(0.0, away - reach));
    }
    if (size <= smallest_ + options_.gradation * radius) return size;
  }
}

}  // namespace quarry
