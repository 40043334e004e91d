#include "pipeline/generate/layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "pipeline/generate/fault.hpp"
#include "pipeline/generate/lot.hpp"
#include "pipeline/generate/portable_math.hpp"
#include "pipeline/generate/refuse.hpp"

namespace quarry {
namespace {

constexpr double kMostPoints = 1e8;
constexpr std::uint64_t kMostFolds = 100;
constexpr std::uint64_t kMostFaults = 1000;
constexpr std::uint64_t kMostHorizons = 1'000'000;
constexpr double kDipScatter = 5;                       // degrees
constexpr double kFlattestDip = 15, kSteepestDip = 90;  // degrees
constexpr double kFoldsAtTheTop =
    0.5;  // their height relative to the lowest horizon's: less than 1 thickens layers in folds
constexpr double kThickness = 0.6;  // how much the thickness of layers varies, relative to its mean

// Items of the lot: each sort of thing has its own.
constexpr std::uint64_t kHorizonItem = std::uint64_t{1} << 32, kFaultItem = std::uint64_t{2} << 32,
                        kFoldItem = std::uint64_t{3} << 32, kOrderItem = std::uint64_t{4} << 32;

// The options with their defaults.
struct LayerLengths {
  double amplitude, mean_throw, step;
};

LayerLengths find_layer_lengths(const LayerOptions& options) {
  require_box(options.box);
  const double width = options.box.width(), height = options.box.height();
  if (options.horizons > kMostHorizons) refuse_option(fmt::format("--horizons: at most {}", kMostHorizons));
  if (options.folds > kMostFolds) refuse_option(fmt::format("--folds: at most {}", kMostFolds));
  if (options.faults > kMostFaults) refuse_option(fmt::format("--faults: at most {}", kMostFaults));
  if (options.horizons + options.faults == 0)
    refuse_option("--horizons 0 --faults 0: there is nothing to draw");
  if (!(options.dip >= kFlattestDip && options.dip <= kSteepestDip))
    refuse_option(fmt::format("--dip {}: degrees from {} to {}", options.dip, kFlattestDip, kSteepestDip));
  const LayerLengths lengths{options.amplitude.value_or(0.1 * height),
                             options.mean_throw.value_or(0.05 * height), options.step.value_or(width / 200)};
  if (!(lengths.amplitude >= 0 && lengths.amplitude <= height))
    refuse_option(fmt::format("--amplitude {}: from 0 to the height of the box", lengths.amplitude));
  if (!(std::abs(lengths.mean_throw) <= height))
    refuse_option(fmt::format("--throw {}: at most the height of the box", lengths.mean_throw));
  if (!(lengths.step > 0 && std::isfinite(lengths.step)))
    refuse_option(fmt::format("--step {}: a length above 0", lengths.step));
  return lengths;
}

struct DrawnFault {
  double place;  // x at half of the height
  Vec2 updip;
  double slip;
};

// In the order in which they form, which is by lot.
std::vector<DrawnFault> draw_faults(const LayerOptions& options, const LayerLengths& lengths) {
  std::vector<std::size_t> cells(options.faults);
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  std::vector<double> keys;
  for (std::size_t i = 0; i < cells.size(); ++i) keys.push_back(Lot(options.seed, kOrderItem + i).uniform());
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<DrawnFault> faults;
  for (const std::size_t cell : cells) {
    Lot lot(options.seed, kFaultItem + cell);
    const double share =
        (static_cast<double>(cell) + lot.uniform(0.2, 0.8)) / static_cast<double>(cells.size());
    const double dip = std::clamp(options.dip + kDipScatter * lot.normal(), kFlattestDip, kSteepestDip);
    const bool to_the_left = lot.uniform() < 0.5;
    const Vec2 rise = portable::direction(dip * std::numbers::pi / 180);
    faults.push_back({options.box.low.x + share * options.box.width(),
                      {to_the_left ? rise.x : -rise.x, rise.y},
                      lot.uniform(0.5, 1.5) * lengths.mean_throw / rise.y});
  }
  return faults;
}

// A height between -1 and 1 above each x, the same for all horizons.
class Folds {
 public:
  explicit Folds(const LayerOptions& options) {
    double sum = 0;
    for (std::uint64_t k = 0; k < options.folds; ++k) {
      Lot lot(options.seed, kFoldItem + k);
      const double waves = lot.uniform(0.5, 1.5 + static_cast<double>(k));
      const double height = lot.uniform(0.5, 1) / waves;
      waves_.push_back(
          {2 * std::numbers::pi * waves / options.box.width(), 2 * std::numbers::pi * lot.uniform(), height});
      sum += height;
    }
    for (Wave& wave : waves_) wave.height /= sum;
  }

  [[nodiscard]] double height(double x) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.height * portable::direction(wave.number * x + wave.phase).y;
    return sum;
  }

 private:
  struct Wave {
    double number, phase, height;
  };
  std::vector<Wave> waves_;
};

// Horizons from beyond one side of the box to beyond the other.
std::vector<DrawnLine> draw_horizons(const LayerOptions& options, const LayerLengths& lengths,
                                     double margin) {
  const Folds folds(options);
  const auto points =
      static_cast<std::size_t>(std::ceil((options.box.width() + 2 * margin) / lengths.step)) + 1;
  std::vector<double> heights(points);
  const auto offset = [&](std::size_t i) { return static_cast<double>(i) * lengths.step - margin; };
  parallel::for_each(points, [&](std::size_t i) { heights[i] = folds.height(offset(i)); });
  std::vector<DrawnLine> lines(options.horizons);
  parallel::for_each(
      lines.size(),
      [&](std::size_t k) {
        Lot lot(options.seed, kHorizonItem + k);
        const double level = (static_cast<double>(k) + 1 + kThickness * (lot.uniform() - 0.5)) /
                             (static_cast<double>(options.horizons) + 1);
        const double amplitude = lengths.amplitude * (1 + (kFoldsAtTheTop - 1) * level);
        lines[k].label = {LineLabel::Kind::kHorizon, static_cast<std::uint32_t>(k), 0};
        lines[k].points.reserve(points);
        for (std::size_t i = 0; i < points; ++i)
          lines[k].points.push_back(
              {options.box.low.x + offset(i),
               options.box.low.y + (level * options.box.height() + amplitude * heights[i])});
      },
      1);
  return lines;
}

}  // namespace

GeneratedModel generate_layers(const LayerOptions& options, const Progress& progress) {
  const LayerLengths lengths = find_layer_lengths(options);
  const std::vector<DrawnFault> faults = draw_faults(options, lengths);
  // As far as all slips together may move a line's end.
  double margin = lengths.step;
  for (const DrawnFault& fault : faults) margin += std::abs(fault.slip);
  const double points =
      static_cast<double>(options.horizons) * (options.box.width() + 2 * margin) / lengths.step;
  if (!(points <= kMostPoints))
    throw Error(
        ErrorKind::kBudget,
        fmt::format("about {:.3g} points would be needed, and {:g} is the limit; give a larger --step",
                    points, kMostPoints));
  std::vector<DrawnLine> lines = draw_horizons(options, lengths, margin);
  const double reach = options.box.width() + options.box.height() + 2 * margin;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    progress.throw_if_cancelled();
    progress.report("faulting", static_cast<double>(i) / static_cast<double>(faults.size()));
    const Vec2 place{faults[i].place, options.box.center().y};
    Fault(place, faults[i].updip, faults[i].slip)
        .apply(lines, reach, {LineLabel::Kind::kFault, static_cast<std::uint32_t>(i), 0});
  }
  GeneratedModel model;
  const ModelFrame frame(options.box, 1e-6 * lengths.step);
  if (options.outline) frame.add_outline(model);
  const auto add = [&](LineLabel::Kind kind) {
    for (const DrawnLine& line : lines)
      if (line.label.kind == kind) frame.add(line.points, line.label, model);
  };
  add(LineLabel::Kind::kHorizon);
  add(LineLabel::Kind::kFault);
  return model;
}

}  // namespace quarry
