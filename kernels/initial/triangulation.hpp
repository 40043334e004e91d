// The Delaunay triangulation of points in the plane, by divide and conquer on exact predicates.
//   L. Guibas, J. Stolfi: Primitives for the manipulation of general subdivisions. ACM Trans. Graphics 4
//   (1985), section 9. R. Dwyer: A faster divide-and-conquer algorithm for constructing Delaunay
//   triangulations. Algorithmica 2 (1987).
// Strips of the points are triangulated at the same time and merged in pairs; where four points lie on one
// circle, the order of the merges decides, which is a function of the points alone.
#pragma once

#include <span>

#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// A mesh whose vertices are the points in their order and whose triangles cover their convex hull: no circle
// through the corners of a triangle has a point inside (exact). Throws Error(kInput) with the place if a
// point is not finite, if two points are equal, or if all lie on one line.
[[nodiscard]] Mesh delaunay_triangulation(std::span<const Vec2> points);

}  // namespace quarry
