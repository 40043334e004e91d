// Collapses the short edges of a surface mesh.
#pragma once

#include "surface/remesh/state.hpp"

namespace quarry {

// A free vertex goes into either end of its edge, one on a feature only along it, as long as the feature is
// not left by more than the options allow; others stay. No edge that would be split may come of it, no
// triangle that faces another way, and none of a measure that is low and lower than the worst before. What
// it won are collapses.
PassReport collapse_short_edges(RemeshState& state, const Progress& progress);

}  // namespace quarry
