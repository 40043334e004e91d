// The fields that a lattice on a surface follows.
#pragma once

#include "engine/base/progress.hpp"
#include "surface/lattice/lattice_state.hpp"
#include "surface/lattice/options.hpp"

namespace quarry {

// Fills place and along of the state, and corrects the scale of its wanted edges where a number of cells is
// asked for: the mesh is cut open along its features, each side of which has crosses of its own, which follow
// the feature; and sewn again. Leaves tombstones.
void find_lattice_fields(LatticeState& state, const LatticeOptions& options, LatticeReport& report,
                         const Progress& progress);

}  // namespace quarry
