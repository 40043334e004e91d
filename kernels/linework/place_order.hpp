// A network numbered by where things are, however its lines were read: what is looked at together lies
// together in memory.
#pragma once

#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Numbers nodes along a Hilbert curve, and raw lines and their paths by where those begin. To be called while
// path p is that of raw line p, and before edges are built.
void order_by_place(PathNetwork& network);

}  // namespace quarry::linework
