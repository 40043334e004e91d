// Flips every edge of a triangle mesh whose two triangles are better the other way.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

// Flips unconstrained interior edges until no flip makes the worse of the two triangles better, by Lo's
// measure. Ends, because each flip puts a better measure in the place of the worst of two. Faces are turned
// one into the other: no vertex moves, none is added. The mesh has triangles only, and ConstraintTags. After
// constraint insertion this removes about half of the triangles below 0.4; smooth afterwards.
PassReport flip_to_better(Mesh& mesh, const Progress& progress);

}  // namespace quarry
