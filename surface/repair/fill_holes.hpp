// The rims of a triangulated surface, and triangles that close them.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

// The closed courses of edges with one triangle, each as its points in the direction of the triangles' sides,
// from its smallest point on. At a point where rims touch, a course goes on along the rim of the same fan of
// triangles.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> rims_of(const TriangleSurface& surface);

struct FilledHole {
  std::vector<std::uint32_t> rim;
  std::vector<SurfaceTriangle> triangles;
  std::int32_t group = 0;  // of a triangle at the rim
};

// Closes each rim of at most so many edges with the triangles between its points whose areas have the least
// sum (Barequet & Sharir, Filling gaps in the boundary of a polyhedron, CAGD 12, 1995), turned as those
// around. No edge is made that is there already: a rim that cannot be closed so is left.
[[nodiscard]] std::vector<FilledHole> fill_holes(const TriangleSurface& surface, std::uint32_t most_edges);

}  // namespace quarry
