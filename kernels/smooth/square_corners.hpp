// Sweeps that make the corners of quads as right-angled, and those of triangles as near to 60 degrees, as the
// mesh's topology allows: what lifts the mean.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/smooth/square_corners_options.hpp"
#include "kernels/smooth/sweep.hpp"

namespace quarry {

// One Gauss-Newton step a vertex and sweep on
//   sum over the corners of its star of tan((wanted - angle) / 2)^2 + spring^2 |p - mean of neighbours|^2
//   / edge^2,
// whole or half or a quarter of it. A move is accepted only if this sum falls, every corner of the star turns
// left (exact), and no face falls below the floor, or, below it, becomes worse. Sliding vertices step along
// their piece; vertices that may not move keep their bits. Before that the rounds together, if any, with a
// sweep after each.
SweepReport square_corners(Mesh& mesh, const NodedLines& lines, const SquareCornersOptions& options,
                           const Progress& progress);

}  // namespace quarry
