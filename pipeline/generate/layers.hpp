// Geological sections drawn by lot: horizons in folds that are sums of sines, and faults that cut and offset
// them.
//
// Faults are straight when they form and cut through everything. One after the other, each slides what lies
// above it, older faults too, down along itself as one block: so there are no gaps, and every line that a
// fault has cut ends in a vertex of the fault, on both sides of it. Not drawn: faults that end within the
// section, drag beside them, erosion.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/progress.hpp"
#include "pipeline/generate/model.hpp"

namespace quarry {

struct LayerOptions {
  Box2 box{{0, 0}, {1000, 500}};
  std::uint64_t horizons = 8;       // from the lowest on, about evenly spaced; before folds and faults
  std::uint64_t folds = 3;          // sines in the sum
  std::optional<double> amplitude;  // the largest height of the folds; default a tenth of the box's height
  std::uint64_t faults = 3;         // about evenly spaced; they dip to the left or to the right by lot
  double dip = 60;                  // degrees from the horizontal; those of the faults scatter by 5 about it
  // The mean vertical offset, of which faults have between a half and three halves; below 0: what lies above
  // the fault moves up. Default a twentieth of the box's height.
  std::optional<double> mean_throw;
  std::optional<double> step;  // between points of a horizon, along x; default a 200th of the box's width
  bool outline = false;        // the box is a line of the model too
  std::uint64_t seed = 0;
};

// Horizons and faults in the order of their numbers; what the box or faults cut in parts has its number on
// each of them. Throws Error(kUsage) for options that are wrong, Error(kBudget) for more points than can be
// held, Error(kInterrupted) once cancelled. The same on any number of threads and on every machine.
[[nodiscard]] GeneratedModel generate_layers(const LayerOptions& options, const Progress& progress);

}  // namespace quarry
