// Opens quads with a straight or reflex corner that no smoothing can bend: the quad and one of the two that
// lie across its far sides are a hexagon, which becomes three quads around a new vertex that is joined to the
// straight corner.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

struct OpeningOptions {
  // Quads with an obtuse corner whose sine is below this are tried.
  double smallest_sine = 0.15;
  // The worst of the three quads must be better than the worst of the two by this much.
  double least_gain = 0.05;
};

// Quad meshes with ConstraintTags, in the plane and in space. New vertices are free and inner; constrained
// sides and the boundary stay. Every quad that was valid and changes becomes a valid one, in the plane
// exactly. Smooth afterwards.
PassReport open_straight_corners(Mesh& mesh, const OpeningOptions& options, const Progress& progress);

}  // namespace quarry
