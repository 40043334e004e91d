// Where a field of crosses has no direction.
#pragma once

#include <span>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/crossfield/field_level.hpp"

namespace quarry {

struct Singularity {
  FaceId triangle;
  // By how many quarter turns the crosses turn around it, counter-clockwise, beyond what the surface asks
  // for: an all-quad mesh that follows them has a vertex of 4 less that many faces there.
  int quarter_turns;
};

// Of a field on the finest level, which is that of the mesh; by triangle. Over a closed surface the turns sum
// to four times its Euler characteristic; over one with rims that the crosses follow too, if it has no
// corners there.
[[nodiscard]] std::vector<Singularity> find_singularities(const Mesh& mesh, const FieldLevel& level,
                                                          std::span<const Vec3> directions);

}  // namespace quarry
