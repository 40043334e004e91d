// Moves the vertices of a surface mesh to better places on the surface.
#pragma once

#include "kernels/smooth/sweep.hpp"
#include "surface/remesh/state.hpp"

namespace quarry {

// Free vertices go towards the mean of the middles of their triangles, weighted by area, in the tangent
// plane, and then to the surface; those on features towards the middle between their two neighbours there. A
// move is taken back if a triangle of the star would face another way, if the worst one becomes low and lower
// than before, or if the surface's nearest point lies farther from the target than the step was long: on
// another sheet.
SweepReport relocate_vertices(RemeshState& state, int sweeps, const Progress& progress);
// The same of vertices with a triangle of a lower measure than that alone.
SweepReport relocate_below(RemeshState& state, double measure, int sweeps, const Progress& progress);

}  // namespace quarry
