// Makes the faces of a planar mesh valid by moving vertices, where the lines around them allow it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// Faces with a corner that does not turn left (exact), ascending.
[[nodiscard]] std::vector<std::uint32_t> invalid_faces(const Mesh& mesh);

// Works on the vertices around invalid faces, in ever larger rings: minimises the regularised shape energy
// (kernels/smooth/local_smoother.hpp), and where that ends in a tangle, starts again from vertices that all
// lie in the middle of those that they are joined to, as in an embedding of Tutte (1963). A round that leaves
// more faces invalid than before is taken back. Needs ConstraintTags: sliding vertices stay on their pieces,
// fixed ones and the rim where they are. Returns how many faces stay invalid.
std::size_t untangle(Mesh& mesh, const NodedLines& lines, const Progress& progress);

}  // namespace quarry
