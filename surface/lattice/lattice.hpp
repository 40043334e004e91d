// From triangles on a surface to others whose vertices are points of a square lattice in the direction of a
// field of crosses: two right-angled ones a cell, but for where the lattice is torn. Quads are paired from
// them across the diagonals. Lattice points are found as in
//   W. Jakob, M. Tarini, D. Panozzo, O. Sorkine-Hornung: Instant field-aligned meshes. ACM TOG 34(6), 2015
// but no mesh is extracted from them: local operations lead there, and the mesh is valid after each.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/lattice/options.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// mesh: as remesh_surface leaves it, with edges of 0.55 to 0.8 spacings. Features keep their nodes and stay
// chains of edges, a whole number of about one spacing each between two nodes. Compact afterwards, in Hilbert
// order, with the normals of the surface at free vertices. The same on any number of threads.
LatticeReport make_lattice(Mesh& mesh, const SurfaceModel& model, const CurveNetwork& network,
                           const SurfaceSizes& spacing, const LatticeOptions& options,
                           const Progress& progress);

}  // namespace quarry
