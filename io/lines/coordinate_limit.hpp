// Which numbers can be coordinates.
#pragma once

#include <cmath>

namespace quarry {

// Beyond this, products of four lengths overflow in exact predicates and quality measures.
inline constexpr double kLargestCoordinate = 1e60;

[[nodiscard]] inline bool is_usable_coordinate(double value) {
  return std::isfinite(value) && std::abs(value) <= kLargestCoordinate;
}

}  // namespace quarry
