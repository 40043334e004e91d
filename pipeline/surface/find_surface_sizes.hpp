// The wanted edges of the triangles that a surface job makes.
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "pipeline/surface/surface.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

struct SizeDemands {
  double edge = 1;  // of the triangles, in input units
  double size = 1;  // of the final elements
  double area = 1;  // of the surface
  // Where a number of elements is wanted that does not do for the details, these are meshed more coarsely, by
  // up to this factor.
  double most_lenient = 16;
  // Where elements are to be smaller whatever else, with the longest edge of a triangle there.
  std::vector<TightPlace> tight;
};

// Smaller where the surface has details, or is curved if an error is given. If a number of elements is
// wanted, those elsewhere are larger for it, and details coarser than they should be where that does not do;
// if the size is, details may take a quarter more elements than the area asks for. mesh: the surface's
// triangles with ConstraintTags.
[[nodiscard]] SurfaceSizes find_surface_sizes(const Mesh& mesh, const SurfaceOptions& options,
                                              const SizeDemands& demands, const Progress& progress);

}  // namespace quarry
