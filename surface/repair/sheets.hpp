// A repaired surface as a mesh. The store knows manifold meshes only: sheets end at joins, and where a
// surface touches itself in a point each fan of triangles has a vertex of its own.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

// The vertex tag (uint32): the number of the point of the surface. Vertices with one number lie in one place
// and are one point in a file.
inline constexpr const char* kSurfacePointTag = "surface_point";
// The face tag (int32): the group of the triangle.
inline constexpr const char* kSurfaceGroupTag = "surface_group";

// The vertex of the first fan at a point has the number of the point, those of others come after all points.
// Face i is triangle i.
[[nodiscard]] Mesh make_sheets(const RepairedSurface& repaired);

}  // namespace quarry
