// What squaring corners weighs and guards, for sweeps over single vertices and for steps of many at once.
#pragma once

#include "kernels/field/size_field.hpp"

namespace quarry {

struct SquareCornersOptions {
  int sweeps = 3;
  // Stars all of whose faces have a measure (sine of the worst corner times aspect factor) above this are
  // left alone at first.
  double content = 0.98;
  // Faces may lose quality for others' sake down to this measure, and never below.
  double floor = 0.6;
  // The same for the longest edge by the shortest, of quads.
  double largest_edge_ratio = 6;
  // The pull towards the mean of the neighbours, which keeps sizes even, against that of the corners.
  double spring = 0.2;
  // The pull of each face's area towards the wanted one, which keeps sizes even where counts are not, against
  // that of the corners. 0: none.
  double evenness = 0;
  // The wanted edge by place, up to a factor, for evenness; see kernels/smooth/wanted_areas.hpp. None: each
  // face is to be as large as those around it are at the start.
  const SizeField* size = nullptr;
  // How far to go along each step: beyond 1, as in successive over-relaxation, long waves of error die
  // sooner.
  double relaxation = 1.5;
  // Before the sweeps: rounds in which the vertices move together, see square_together.hpp, with a sweep
  // after each. Five stand in for thirty sweeps, in less than half of their time (docs/results-quads.md).
  int rounds_together = 0;
  // A vertex that would move by less than this share of its shortest edge stays where it is.
  double tolerance = 0.01;
};

}  // namespace quarry
