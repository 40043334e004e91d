// Puts the vertices of a mesh where the surface is.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

// Binds vertices that subdivide_in_space left fixed in the middle of a feature between two nodes to it, but
// for those where sheets meet.
void bind_middles(const Mesh& mesh, ConstraintTags tags, const CurveNetwork& network);

// Free vertices go to the surface, those bound to a feature to its curve, as far as no face that is low
// becomes lower: the rest of the way is left to smoothing. Gives the mesh its normals (Mesh::add_normals):
// those of the surface at free vertices.
void place_on_surface(Mesh& mesh, ConstraintTags tags, const SurfaceModel& model, const CurveNetwork& network,
                      const Progress& progress);

// The normals at vertices that are on features or rims: the mean of those of the faces around, each vertex of
// a mesh that is cut open along its features having those of one side only.
void set_feature_normals(Mesh& cut_open, const ConstraintTags& tags);
// Zero in their place, which has no say: for meshes that are not cut open, where several sides meet.
void clear_feature_normals(Mesh& mesh, const ConstraintTags& tags);

}  // namespace quarry
