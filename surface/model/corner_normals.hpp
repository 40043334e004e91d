// The normals of a surface at the corners of its triangles.
#pragma once

#include <array>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// One a triangle, in the order of its corners, each of length 1.
using CornerNormals = std::array<Vec3, 3>;

// The mean of the normals of the triangles around the corner, weighted by their angles there (Thuermer &
// Wuethrich, Computing vertex normals from polygonal facets, JGT 3, 1998), as far as one gets without
// crossing a constrained side: a vertex on a sharp edge has a normal for each side of it, and a node on no
// edge, the tip of a cone, one for each triangle: theirs would look ahead, and with it those far down the
// triangles of a needle. Triangles without
// area borrow from those around; where all are so the normal is (0, 0, 1).
[[nodiscard]] std::vector<CornerNormals> corner_normals(const Mesh& triangles, const ConstraintTags& tags);

}  // namespace quarry
