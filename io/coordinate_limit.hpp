// Which numbers can be coordinates, of lines and of meshes.
#pragma once

#include <cmath>

namespace quarry {

// Smoothing works in single precision, which ends at 3e38: this leaves lengths and their sums room below it,
// and products of four lengths in exact predicates and quality measures room in doubles.
inline constexpr double kLargestCoordinate = 1e30;

[[nodiscard]] inline bool is_usable_coordinate(double value) {
  return std::isfinite(value) && std::abs(value) <= kLargestCoordinate;
}

}  // namespace quarry
