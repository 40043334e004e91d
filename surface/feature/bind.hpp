// Binds the vertices of a mesh to the features of its surface.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "surface/feature/curve_network.hpp"

namespace quarry {

// For a mesh as make_sheets gives it, or of other faces with kSurfacePointTag: adds ConstraintTags, with all
// sides on features constrained, vertices at nodes and those that share their point with another
// (surface/repair/sheets.hpp) fixed, and the others on features bound to their curve.
ConstraintTags bind_features(Mesh& sheets, const CurveNetwork& network);

// Fixes the vertices of rims, which slide along them else, to their places.
void fix_rims(const Mesh& sheets, ConstraintTags tags);

}  // namespace quarry
