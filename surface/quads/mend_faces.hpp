// The last means against faces of a surface mesh that are turned over.
#pragma once

#include <cstddef>

#include "engine/base/progress.hpp"
#include "engine/geometry/model.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// Untangles the free vertices around each face that is turned over, or turned from the surface, by the
// normals of the mesh (Mesh::normals); a smaller neighbourhood first, then larger ones. What leaves no fewer
// such faces is taken back. Does nothing where they are more than a matter of single faces. Returns how many
// are left.
std::size_t mend_faces(Mesh& mesh, const ConstraintTags& tags, const SpaceModel& model,
                       const Progress& progress);

}  // namespace quarry
