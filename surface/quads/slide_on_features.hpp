// Better places along features for the vertices of a quad mesh that lie on them.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/smooth/sweep.hpp"
#include "surface/feature/curve_network.hpp"

namespace quarry {

// Vertices that slide on a curve go to where the scaled Jacobians of the faces around them have a larger sum,
// as far as none that is low becomes lower, and none turns much; nodes and fixed vertices stay. Needs the
// normals of the mesh, features without one. sweeps: at most so many over all of them. The same on any number
// of threads.
SweepReport slide_on_features(Mesh& mesh, const ConstraintTags& tags, const CurveNetwork& network, int sweeps,
                              const Progress& progress);

}  // namespace quarry
