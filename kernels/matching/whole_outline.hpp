// Takes the vertices that insertion has put between the nodes of an outline out again, so that the boundary's
// vertices are the outline's own.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

// Removes each boundary vertex that slides on a piece of kind kOutline; what was joined to it is triangulated
// anew, best triangle first, with the straight edge between its neighbours on the piece as a side. Planar
// triangle meshes with ConstraintTags, after remove_outside. Leaves tombstones. No vertex moves. Throws
// Error(kGeometry) with the place of a vertex without which no valid triangles are left.
PassReport make_outline_whole(Mesh& mesh, const NodedLines& lines, const Progress& progress);

}  // namespace quarry
