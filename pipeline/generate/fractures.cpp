#include "pipeline/generate/fractures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "pipeline/generate/lot.hpp"
#include "pipeline/generate/portable_math.hpp"
#include "pipeline/generate/refuse.hpp"

namespace quarry {
namespace {

constexpr double kMostFractures = 5e7;
constexpr double kLargestExponent = 20;
constexpr double kLargestKappa = 1e8;
constexpr double kLargestRatio = 1e9;   // of the longest length to the shortest
constexpr double kLongestInBoxes = 10;  // the longest fracture, in longer sides of the box
constexpr double kMostMisses = 1000;    // drawn fractures for each one that meets the box
constexpr double kFewFractures = 1000;  // before which nobody judges that
constexpr std::size_t kBlock = 8192;    // fractures drawn at a time
constexpr int kMostPieces = 64;
constexpr double kBend = 0.15;  // standard deviation of the angle by which an arc turns, radians
constexpr double kWave = 0.12;  // amplitude of the undulation of its direction, radians

void check_fractures(const FractureOptions& options) {
  require_box(options.box);
  if (options.count.has_value() == options.intensity.has_value())
    refuse_option("give the number of fractures with --count, or their length by area with --p21");
  if (options.count && *options.count == 0) refuse_option("--count 0: at least one fracture");
  if (options.intensity && !(*options.intensity > 0 && std::isfinite(*options.intensity)))
    refuse_option(fmt::format("--p21 {}: a number above 0", *options.intensity));
  if (!(options.exponent >= 0 && options.exponent <= kLargestExponent))
    refuse_option(fmt::format("--exponent {}: a number from 0 to {}", options.exponent, kLargestExponent));
  if (options.sets.empty()) refuse_option("at least one set of directions is needed");
  double weights = 0;
  for (const FractureSet& set : options.sets) {
    if (!(std::abs(set.degrees) <= 360))
      refuse_option(fmt::format("--set: {} is no angle of a set", set.degrees));
    if (!(set.kappa >= 0 && set.kappa <= kLargestKappa))
      refuse_option(fmt::format("--set: a concentration of {}: from 0 to {:g}", set.kappa, kLargestKappa));
    if (!(set.weight >= 0 && std::isfinite(set.weight)))
      refuse_option(fmt::format("--set: a weight of {}: 0 or more", set.weight));
    weights += set.weight;
  }
  if (!(weights > 0 && std::isfinite(weights))) refuse_option("--set: the weights are all 0, or too large");
}

struct FractureLengths {
  double shortest, longest;
};

FractureLengths find_fracture_lengths(const FractureOptions& options) {
  const double area = options.box.width() * options.box.height();
  FractureLengths lengths{};
  if (options.shortest)
    lengths.shortest = *options.shortest;
  else
    lengths.shortest = options.count ? 0.7 * std::sqrt(area / static_cast<double>(*options.count))
                                     : 1.5 / *options.intensity;
  const double half = 0.5 * std::min(options.box.width(), options.box.height());
  lengths.longest = options.longest ? *options.longest : std::max(half, lengths.shortest);
  if (!options.shortest) lengths.shortest = std::min(lengths.shortest, lengths.longest);
  if (!(lengths.shortest > 0 && std::isfinite(lengths.longest)))
    refuse_option(fmt::format("--lmin {} --lmax {}: lengths above 0", lengths.shortest, lengths.longest));
  if (!(lengths.shortest <= lengths.longest))
    refuse_option(fmt::format("--lmin {} is more than --lmax {}", lengths.shortest, lengths.longest));
  if (lengths.longest > kLargestRatio * lengths.shortest)
    refuse_option(fmt::format("--lmin {} --lmax {}: more than {:g} times as long", lengths.shortest,
                              lengths.longest, kLargestRatio));
  if (lengths.longest > kLongestInBoxes * options.box.longer_side())
    refuse_option(fmt::format("--lmax {}: at most {} times the longer side of the box", lengths.longest,
                              kLongestInBoxes));
  return lengths;
}

// A fracture of length l can meet the box if its centre is nearer than l / 2: in an area of (w + l)(h + l) at
// most. Those that can are drawn alone: of l with density l^-a (wh + (w + h) l + l^2), a mixture of three
// power laws.
class FractureLaw {
 public:
  FractureLaw(const FractureOptions& options, const FractureLengths& lengths)
      : options_(options), lengths_(lengths) {
    const double l = lengths.shortest;
    const double around[] = {options.box.width() * options.box.height(),
                             l * (options.box.width() + options.box.height()), l * l};
    for (int k = 0; k < 3; ++k) {
      laws_.emplace_back(options.exponent - k, lengths.shortest, lengths.longest);
      weights_.push_back(around[k] * laws_.back().integral());
    }
    for (const FractureSet& set : options.sets) {
      scatter_.emplace_back(set.kappa);
      axes_.push_back(portable::direction(set.degrees * std::numbers::pi / 180));
      set_weights_.push_back(set.weight);
    }
  }

  // About how many can meet a box in which their intensity is P21.
  [[nodiscard]] double count_of(double intensity) const {
    const double mean_length = lengths_.shortest * laws_[1].integral() / laws_[0].integral();
    return intensity / mean_length * (weights_[0] + weights_[1] + weights_[2]) / laws_[0].integral();
  }

  struct Fracture {
    std::vector<Vec2> points;
    std::uint32_t set = 0;
  };

  [[nodiscard]] Fracture draw(std::uint64_t item) const {
    Lot lot(options_.seed, item);
    Fracture fracture;
    const double length = laws_[pick(weights_, lot)].draw(lot);
    fracture.set = static_cast<std::uint32_t>(pick(set_weights_, lot));
    const Box2 reach = options_.box.grown(0.5 * length);
    const Vec2 centre{lot.uniform(reach.low.x, reach.high.x), lot.uniform(reach.low.y, reach.high.y)};
    const Vec2 along = turned(axes_[fracture.set], scatter_[fracture.set].draw(lot));
    fracture.points = options_.curved
                          ? arc(centre, along, length, lot)
                          : std::vector{centre - (0.5 * length) * along, centre + (0.5 * length) * along};
    return fracture;
  }

 private:
  static Vec2 turned(Vec2 vector, Vec2 by) {
    return {vector.x * by.x - vector.y * by.y, vector.x * by.y + vector.y * by.x};
  }

  static std::size_t pick(const std::vector<double>& weights, Lot& lot) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    double left = lot.uniform() * sum;
    for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
      if (left < weights[i]) return i;
      left -= weights[i];
    }
    // The last that can be drawn: rounding may leave more than nothing beyond it.
    std::size_t last = weights.size() - 1;
    while (weights[last] == 0) --last;
    return last;
  }

  // Its chord's middle is the centre.
  [[nodiscard]] std::vector<Vec2> arc(Vec2 centre, Vec2 along, double length, Lot& lot) const {
    const int pieces = std::min(kMostPieces, 2 + static_cast<int>(length / lengths_.shortest));
    const double bend = kBend * lot.normal(), wave = kWave * lot.normal();
    const double phase = 2 * std::numbers::pi * lot.uniform(),
                 turns = 2 * std::numbers::pi * lot.uniform(1, 2);
    std::vector<Vec2> points{{0, 0}};
    for (int i = 0; i < pieces; ++i) {
      const double t = (i + 0.5) / pieces;
      const double turn = bend * (t - 0.5) + wave * portable::direction(phase + turns * t).x;
      points.push_back(points.back() + (length / pieces) * turned(along, portable::direction(turn)));
    }
    const Vec2 shift = centre - 0.5 * points.back();
    for (Vec2& point : points) point = point + shift;
    return points;
  }

  const FractureOptions& options_;
  FractureLengths lengths_;
  std::vector<PowerLaw> laws_;
  std::vector<double> weights_, set_weights_;
  std::vector<VonMises> scatter_;
  std::vector<Vec2> axes_;
};

// The fractures of a block in their order, as far as they are wanted.
class Collector {
 public:
  Collector(const FractureOptions& options, const ModelFrame& frame)
      : options_(options), frame_(frame), wanted_length_(0) {
    if (options.outline) frame.add_outline(model_);
    if (options.intensity) wanted_length_ = *options.intensity * options.box.width() * options.box.height();
  }

  [[nodiscard]] bool done() const { return done_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double share() const {
    return options_.count ? static_cast<double>(count_) / static_cast<double>(*options_.count)
                          : std::min(1.0, model_.total_length / wanted_length_);
  }

  void add(const FractureLaw::Fracture& fracture) {
    const std::size_t lines = model_.lines.lines.size(), segments = model_.segments;
    const double before = model_.total_length;
    const LineLabel label{LineLabel::Kind::kFracture, static_cast<std::uint32_t>(count_), fracture.set};
    if (frame_.add(fracture.points, label, model_) == 0) return;
    ++count_;
    if (options_.count) {
      done_ = count_ == *options_.count;
      return;
    }
    done_ = model_.total_length >= wanted_length_;
    // The last one stays where the intensity is nearer to what is wanted with it.
    if (!done_ || count_ == 1 || model_.total_length - wanted_length_ <= wanted_length_ - before) return;
    model_.lines.lines.raw().resize(lines);
    model_.labels.resize(lines);
    model_.segments = segments;
    model_.total_length = before;
  }

  GeneratedModel take() { return std::move(model_); }

 private:
  const FractureOptions& options_;
  const ModelFrame& frame_;
  double wanted_length_;
  std::uint64_t count_ = 0;
  bool done_ = false;
  GeneratedModel model_;
};

}  // namespace

GeneratedModel generate_fractures(const FractureOptions& options, const Progress& progress) {
  check_fractures(options);
  const FractureLengths lengths = find_fracture_lengths(options);
  const FractureLaw law(options, lengths);
  const double expected =
      options.count ? static_cast<double>(*options.count) : law.count_of(*options.intensity);
  if (!(expected <= kMostFractures))
    throw Error(
        ErrorKind::kBudget,
        fmt::format("about {:.3g} fractures would be needed, and {:g} is the limit; ask for fewer, for a "
                    "lower --p21 or for a larger --lmin",
                    expected, kMostFractures));
  const ModelFrame frame(options.box, 1e-6 * lengths.shortest);
  Collector collector(options, frame);
  std::vector<FractureLaw::Fracture> block(kBlock);
  for (std::uint64_t first = 0; !collector.done(); first += kBlock) {
    progress.throw_if_cancelled();
    progress.report("drawing", collector.share());
    if (static_cast<double>(first) > kMostMisses * (kFewFractures + static_cast<double>(collector.count())))
      throw Error(ErrorKind::kBudget,
                  "nearly all fractures of these lengths miss the box; give a lower --lmax");
    parallel::for_each(
        kBlock, [&](std::size_t i) { block[i] = law.draw(first + i); }, 256);
    for (std::size_t i = 0; i < kBlock && !collector.done(); ++i) collector.add(block[i]);
  }
  return collector.take();
}

}  // namespace quarry
