// Moves the vertices of a surface mesh to their lattice points.
#pragma once

#include "kernels/smooth/sweep.hpp"
#include "surface/lattice/lattice_state.hpp"

namespace quarry {

// To the place on the surface, or on the feature, that is nearest to the point; all the way or a part of it,
// as far as no triangle turns over, and none becomes lower that is below `content` (Lo's measure).
SweepReport snap_to_lattice(LatticeState& state, int sweeps, double content, const Progress& progress);

}  // namespace quarry
