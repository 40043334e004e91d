// Flat triangles of a surface whose corners lie in a row.
#pragma once

#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

// Ear cutters and CAD exporters make triangles of three points in a row where an edge on one side meets two
// on the other. Their normals are noise. Each goes, and the triangles across its longest edge are cut at its
// third point; across a rim there is none. Triangles are flat that are lower than 1e-10 of their longest
// edge, or than coordinates tell apart; those with two points all but at one place are left, and so is a
// surface of flat ones alone. New triangles come last. Returns the third points.
std::vector<Vec3> cut_at_caps(TriangleSurface& surface);

}  // namespace quarry
