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
  // No triangle may come to have a longest edge beyond so many times its shortest, and more unequal edges
  // than before. Of quads the measure tells.
  double largest_triangle_ratio = 6;
  // Moves shorter than this share of the edges at the vertex are not looked for.
  double smallest_step = 0.01;
};

// For one vertex after the other, searches the place with the smallest sum of 1 / measure over the faces of
// its star (kernels/smooth/star.hpp: squared corner sines with an aspect guard) among those where the worst
// face is no worse than before. To lift the worst alone would stop at faces that no move can help; sums of
// higher powers, which are nearer to it, end with as many bad faces and a lower mean. Every corner turns left
// (exact) after each move, and vertices that may not move keep their bits.
SweepReport optimise_corners(Mesh& mesh, const NodedLines& lines, const OptimiseOptions& options,
                             const Progress& progress);

}  // namespace quarry
