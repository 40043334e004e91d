// Guarded Laplacian smoothing of a planar mesh of triangles, quads or both.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/smooth/sweep.hpp"

namespace quarry {

struct LaplacianOptions {
  int sweeps = 10;
  // A vertex nearer to its target than this share of its shortest edge stays where it is.
  double tolerance = 0.02;
};

// Moves each vertex to the mean of the vertices that it is joined to, or half or a quarter of the way.
// Sliding vertices go to the nearest point of their piece; nodes, fixed vertices and free vertices on the rim
// keep their bits. A move is accepted only if every corner of the star turns left (exact) and the worst face
// of the star, by the measure of kernels/smooth/star.hpp, does not become worse: without that guard edges
// collapse. The plain mean: weights of 1/length (the scale-dependent umbrella) make it the iteration for the
// geometric median, which may end on a neighbour.
SweepReport smooth_laplacian(Mesh& mesh, const NodedLines& lines, const LaplacianOptions& options,
                             const Progress& progress);

}  // namespace quarry
