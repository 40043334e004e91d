// Lattice points along the features of a surface mesh.
#pragma once

#include "surface/lattice/lattice_state.hpp"

namespace quarry {

// Each curve of the network is divided into a whole number of parts of about the wanted edges; each vertex on
// it gets the nearest of the points between them. Nodes, and what is fixed to a place of its own, have
// themselves.
void place_on_chains(LatticeState& state);

}  // namespace quarry
