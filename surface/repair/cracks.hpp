// Rims that lie so near to one another that they were one: an export whose points were rounded apart.
#pragma once

#include <cstddef>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

struct Cracks {
  std::size_t rim_points = 0;
  std::size_t near_others = 0;  // of them, within the distance of another one
  double distance = 0;          // in input units: a share of the median edge of rims

  // Too many to be a matter of single places.
  [[nodiscard]] bool likely() const { return 2 * near_others > rim_points; }
};

[[nodiscard]] Cracks find_cracks(const TriangleSurface& surface);

}  // namespace quarry
