#include "pipeline/section/options.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

// Bytes at the peak of a job, measured: see docs/results.md.
constexpr double kBytesPerElement = 200;
// Products of four lengths of a finer mesh would leave the range of normal numbers.
constexpr double kSmallestDomain = 1e-50;
constexpr double kBytesOfAnyJob = 50e6;
// Araujo & Celes 2014, section 3.2: 4 or 5 steps.
constexpr int kPublishedFrontSteps = 4;
// Equilateral triangles of side h take this share of h * h.
constexpr double kTriangleArea = 0.4330127018922193;

double positive_or_default(const std::optional<double>& value, double fallback, const char* name) {
  if (!value) return fallback;
  if (!(*value >= 0) || !std::isfinite(*value))
    throw Error(ErrorKind::kUsage,
                fmt::format("{} is {}: it must be a length of 0 or more in input units", name, *value));
  return *value;
}

}  // namespace

bool makes_quads(const SectionOptions& options) { return options.elements != Elements::kTriangle; }

CleanUpLevel clean_up_level(const SectionOptions& options) {
  if (!makes_quads(options)) return CleanUpLevel::kNone;
  return options.cleanup.value_or(options.preset == Preset::kPaper ? CleanUpLevel::kNone
                                                                   : CleanUpLevel::kFull);
}

double closed_wedge(const SectionOptions& options) {
  constexpr double kUsual = 5;
  return options.preset == Preset::kPaper || options.keep_boundary ? 0 : kUsual;
}

int front_steps(const SectionOptions& options) {
  if (!makes_quads(options)) return 0;
  const int of_preset = options.preset == Preset::kPaper ? kPublishedFrontSteps : 0;
  return options.fronts.value_or(of_preset);
}

double predict_elements(const SectionOptions& options, const Box2& box, double size,
                        const WantedSizes* sizes) {
  const double cells = sizes == nullptr
                           ? (box.width() / size + 1) * (box.height() / size + 1)
                           : sizes->count_squares(box, squares_of(options, options.max_elements));
  return cells / squares_of(options, 1);
}

double squares_of(const SectionOptions& options, double elements) {
  return makes_quads(options) ? elements : kTriangleArea * elements;
}

double predict_bytes(double elements) { return kBytesOfAnyJob + kBytesPerElement * elements; }

double resolve_size(const SectionOptions& options, const Box2& box, double area) {
  if (box.longer_side() < kSmallestDomain)
    throw Error(ErrorKind::kInput,
                fmt::format("{}: the domain is {:.3g} wide: lengths so small underflow; use another unit",
                            fmt::join(options.inputs, ", "), box.longer_side()));
  if (options.size.has_value() == options.count.has_value())
    throw Error(ErrorKind::kUsage, "give either --size or --count");
  double size = 0;
  if (options.size) {
    size = *options.size;
    if (!(size > 0) || !std::isfinite(size))
      throw Error(ErrorKind::kUsage,
                  fmt::format("--size is {}: it must be a length above 0 in input units", *options.size));
  } else {
    if (!(*options.count >= 1) || !std::isfinite(*options.count))
      throw Error(ErrorKind::kUsage, fmt::format("--count is {}: it must be 1 or more", *options.count));
    size = std::sqrt(area / squares_of(options, *options.count));
  }
  if (size > box.longer_side())
    throw Error(
        ErrorKind::kUsage,
        fmt::format(
            "the size {:.6g} is larger than the domain, whose longer side is {:.6g}: take a smaller --size",
            size, box.longer_side()));
  return size;
}

ResolvedLengths resolve_lengths(const SectionOptions& options, double size, double smallest) {
  ResolvedLengths lengths;
  lengths.size = size;
  lengths.snap = positive_or_default(options.snap, 0.05 * smallest, "--snap");
  lengths.min_edge = positive_or_default(options.min_edge, 0.1 * smallest, "--min-edge");
  lengths.tolerance = positive_or_default(options.tolerance, 0.05 * smallest, "--tolerance");
  return lengths;
}

void require_within_budget(const SectionOptions& options, double size, double elements) {
  if (elements > options.max_elements)
    throw Error(
        ErrorKind::kBudget,
        fmt::format(
            "a size of {:.6g} means about {:.3g} elements and {:.3g} GB of memory, beyond --max-elements "
            "{:.3g}: take a larger --size, or raise the limit",
            size, elements, predict_bytes(elements) / 1e9, options.max_elements));
}

}  // namespace quarry
