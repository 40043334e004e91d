// How large the faces of a planar mesh are to be, for sweeps that keep sizes in order.
#pragma once

#include "engine/base/id.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

// The signed area of a quad, twice that of a triangle: what corners of both have in common.
[[nodiscard]] double corner_area(const Mesh& mesh, FaceId f);

// The corner areas wanted, by face slot; all positive where the mesh has area. With a size they are the
// squares of the wanted edges at the middles of the faces, scaled so that their sum is the area that there
// is; without one (null) each is the mean over the faces around the face, so that what is large among small
// ones stands back. The same on any number of threads.
[[nodiscard]] IdVector<FaceId, double> wanted_areas(const Mesh& mesh, const SizeField* size);

}  // namespace quarry
