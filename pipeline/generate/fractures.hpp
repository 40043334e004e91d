// Fracture networks drawn by lot, as trace maps show them: lengths by a power law (Bonnet et al. 2001), sets
// of directions with scatter (von Mises), centres anywhere. What crosses the sides of the box is cut off
// there, so that the network is as dense beside them as elsewhere.
//
// Fractures know nothing of one another: they cross, and end anywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/progress.hpp"
#include "pipeline/generate/model.hpp"

namespace quarry {

struct FractureSet {
  double degrees = 0;  // counter-clockwise from the x axis
  double kappa =
      30;  // concentration of von Mises' law; 30: a standard deviation of 10 degrees, 0: any direction
  double weight = 1;  // how many of the fractures, relative to the other sets
};

struct FractureOptions {
  Box2 box{{0, 0}, {1000, 1000}};
  // One of the two.
  std::optional<std::uint64_t> count;  // fractures of which a part lies in the box
  std::optional<double> intensity;     // P21: their length within the box by its area, 1 / units
  double exponent = 2.5;               // of p(l) ~ l^-exponent
  // Lengths before the box cuts them. By default the longest is half of the box's shorter side, and the
  // shortest is such that about the same share of the fractures meets others whatever the count: 0.7
  // sqrt(area / count), or 1.5 / intensity.
  std::optional<double> shortest, longest;
  std::vector<FractureSet> sets = {{30, 30, 0.6}, {120, 30, 0.4}};
  // Arcs with an undulation, of pieces as long as the shortest fracture or longer, in place of straight
  // segments.
  bool curved = false;
  bool outline = false;  // the box is a line of the model too
  std::uint64_t seed = 0;
};

// Throws Error(kUsage) for options that are wrong or contradict one another, Error(kBudget) where more
// fractures would be needed than can be held, or nearly all of them would miss the box, Error(kInterrupted)
// once cancelled. The same on any number of threads and on every machine.
[[nodiscard]] GeneratedModel generate_fractures(const FractureOptions& options, const Progress& progress);

}  // namespace quarry
