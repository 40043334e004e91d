// Before a mesh can be the surface that better faces are to lie on, none of its own may be folded over.
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// Faces that are not convex, without area, or turned away from the direction that the faces around their
// corners have on the whole (kernels/quality/space_face.hpp). Gives the mesh these directions as normals.
// Ascending.
[[nodiscard]] std::vector<FaceId> find_folded_faces(Mesh& mesh);

// Untangles the free vertices around such faces, each in the plane across its normal; what is bound stays.
// Does nothing where they are more than a matter of single faces (mend_faces). mesh: with the normals that
// find_folded_faces gives it, which go.
void unfold_faces(Mesh& mesh, const ConstraintTags& tags, const Progress& progress);

}  // namespace quarry
