// Brings a mesh back to what of its surface it has lost: tips and pits that its elements bridge.
#pragma once

#include <cstddef>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

struct ReachOptions {
  // A point of the surface is far if the mesh lies farther away than this share of the edge of the quad
  // there.
  double far = 0.4;
  // No face may become worse than this, nor worse than it is if it is worse.
  double least_jacobian = 0.2;
  int rounds = 5;
  int sweeps = 4;  // over the vertices around those that were moved
};

// Of the free corners of the face that is nearest to a far point of the surface's own, the nearest that can
// goes there and stays, the farthest point first, no two that share a face in one round; those around it are
// smoothed. Needs the normals of the mesh, features without one. Returns how many vertices were moved. The
// same on any number of threads.
std::size_t reach_far_points(Mesh& mesh, const ConstraintTags& tags, const SurfaceModel& model,
                             const ReachOptions& options, const Progress& progress);

}  // namespace quarry
