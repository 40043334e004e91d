// Triangle meshes given by the user as a start, down to four triangles over the domain.
#pragma once

#include "engine/geometry/box.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The points and triangles of a mesh as a start: turned over if all triangles turn right, points without a
// triangle left out, in Hilbert order; tags, sets and edges are not taken over. Throws Error(kInput) with the
// place if it is not flat, has other faces than triangles, has triangles of no area or of both orientations,
// lies in several parts, has holes, or overlaps itself.
[[nodiscard]] Mesh adopt_start_mesh(const Mesh& given);

// Throws Error(kInput) with the place where a line leaves or touches the rim of the mesh.
void require_lines_inside(const Mesh& mesh, const NodedLines& lines);

// The box, grown by a tenth of its longer side, cut along its diagonals (Araujo & Celes 2014, Fig. 13).
[[nodiscard]] Mesh make_four_triangles(const Box2& box);

}  // namespace quarry
