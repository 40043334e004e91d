// Splits the long edges of a surface mesh.
#pragma once

#include "surface/remesh/state.hpp"

namespace quarry {

// One pass over all edges that are too long and the longest of one of their triangles: splitting others first
// makes needles. New vertices lie on the surface, or on the feature whose edge is split; where the surface
// turns too far for that they lie on the edge. What it won are splits; edges may be left.
PassReport split_long_edges(RemeshState& state, const Progress& progress);

}  // namespace quarry
