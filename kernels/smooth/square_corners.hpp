// Sweeps that make the corners of quads as right-angled, and those of triangles as near to 60 degrees, as the
// mesh's topology allows: what lifts the mean.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/smooth/sweep.hpp"

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
  // A vertex that would move by less than this share of its shortest edge stays where it is.
  double tolerance = 0.01;
};

// One Gauss-Newton step a vertex and sweep on
//   sum over the corners of its star of tan((wanted - angle) / 2)^2 + spring^2 |p - mean of neighbours|^2
//   / edge^2,
// whole or half or a quarter of it. A move is accepted only if this sum falls, every corner of the star turns
// left (exact), and no face falls below the floor, or, below it, becomes worse. Sliding vertices step along
// their piece; vertices that may not move keep their bits.
SweepReport square_corners(Mesh& mesh, const NodedLines& lines, const SquareCornersOptions& options,
                           const Progress& progress);

}  // namespace quarry
