// The wanted edges of the triangles that a surface job makes.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "pipeline/surface/surface.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// Smaller where the surface has details, or is curved if an error is given. If a number of elements is
// wanted, those elsewhere are larger for it, and details coarser than they should be where that does not do;
// if the size is, details may take a quarter more elements than the area asks for. mesh: the surface's
// triangles with ConstraintTags; edge: of the triangles; size: of the final elements; area: of the surface.
[[nodiscard]] SurfaceSizes find_surface_sizes(const Mesh& mesh, const SurfaceOptions& options, double edge,
                                              double size, double area, const Progress& progress);

}  // namespace quarry
