// Triangles of a wanted size on a surface: splits of what is too long, collapses of what is too short, flips
// and moves, round by round, with the mesh valid after each change. Features and rims stay chains of edges.
// As
//   M. Botsch, L. Kobbelt: A remeshing approach to multiresolution modeling. SGP 2004
// with guards against folds and jumps, and all of it in parallel passes.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/remesh/options.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// mesh: triangles on the surface with ConstraintTags, as make_sheets and bind_features leave them, and as the
// sizes know them. A triangle is to have the area of an equilateral one of the wanted edge there. Vertices
// that are fixed keep their bits. Compact afterwards, in Hilbert order, with the normals of the surface at
// free vertices, and none (zero) at those on features, which may have several. The same on any number of
// threads.
RemeshReport remesh_surface(Mesh& mesh, const SurfaceModel& model, const CurveNetwork& network,
                            const SurfaceSizes& sizes, const RemeshOptions& options,
                            const Progress& progress);

}  // namespace quarry
