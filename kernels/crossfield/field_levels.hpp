// From the finest level of a field to coarser ones, which see its long waves.
#pragma once

#include <cstddef>
#include <vector>

#include "kernels/crossfield/field_level.hpp"

namespace quarry {

// Fine to coarse, until at most `fewest` free vertices are left, or none can be joined. From level to level
// free vertices are joined two by two, strongest connections first, and the Laplacian A becomes P^H A P, with
// the turns in P that make the two agree; vertices that are given stay by themselves. The same on any number
// of threads.
[[nodiscard]] std::vector<FieldLevel> field_levels(FieldLevel finest, std::size_t fewest);

}  // namespace quarry
