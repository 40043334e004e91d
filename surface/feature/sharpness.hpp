// From which angle on the edges of a surface are sharp, as the surface itself tells.
#pragma once

#include <vector>

#include "surface/repair/surface_edges.hpp"

namespace quarry {

// The angle by which the surface turns at each edge of two triangles, in radians; 0 at other edges and beside
// triangles without area.
[[nodiscard]] std::vector<double> dihedral_angles(const TriangleSurface& surface, const SurfaceEdges& edges);

// In degrees: the smallest of 30, 35, ... 60 such that edges that turn by more are at least twice as long,
// all together, as those that turn by between half of it and all of it. That parts made surfaces, whose edges
// turn by little or by much, from scans, whose edges turn by whatever their size and noise make of them: of
// these only the edges are sharp at which the surface turns back on itself, as at the rims of thin walls:
// kKnifeEdge is returned.
inline constexpr double kKnifeEdge = 110;
[[nodiscard]] double find_sharpness(const TriangleSurface& surface, const SurfaceEdges& edges,
                                    const std::vector<double>& angles);

}  // namespace quarry
