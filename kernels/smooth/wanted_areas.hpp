// How large the faces of a planar mesh are to be, for sweeps that keep sizes in order.
#pragma once

#include "engine/base/id.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/smooth/corner_residual.hpp"

namespace quarry {

// The signed area of a quad, twice that of a triangle: what corners of both have in common.
[[nodiscard]] double corner_area(const Mesh& mesh, FaceId f);

// The corner areas wanted, by face slot; all positive where the mesh has area. With a size they are the
// squares of the wanted edges at the middles of the faces, scaled so that their sum is the area that there
// is; without one (null) each is the mean over the faces around the face, so that what is large among small
// ones stands back. The same on any number of threads.
[[nodiscard]] IdVector<FaceId, double> wanted_areas(const Mesh& mesh, const SizeField* size);

// What is asked of the area of each face, by face slot: the wanted area by the size, with the weight
// `evenness`, which fades where the faces around have no room for it, as between lines that come close. Empty
// if evenness is zero.
[[nodiscard]] IdVector<FaceId, AreaDemand> area_demands(const Mesh& mesh, double evenness,
                                                        const SizeField* size);

}  // namespace quarry
