// The corner optimiser: lifts the worst faces of a planar quad (or mixed) mesh.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/smooth/sweep.hpp"

namespace quarry {

struct OptimiseOptions {
  int sweeps = 6;
  // Stars whose worst face has a measure (sine of the worst corner times aspect factor) of this or more are
  // left alone.
  double target = 0.7;
  // Moves shorter than this share of the shortest edge are not looked for.
  double smallest_step = 0.01;
};

// For one vertex after the other, searches the place that maximises the measure of the worst face of its star
// (kernels/smooth/star.hpp: corner sines with an aspect guard). A star's worst face never becomes worse,
// every corner turns left (exact) after each move, and vertices that may not move keep their bits.
SweepReport optimise_corners(Mesh& mesh, const NodedLines& lines, const OptimiseOptions& options,
                             const Progress& progress);

}  // namespace quarry
