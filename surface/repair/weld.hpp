// Points at one place become one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

// For each point the number of the point that stands for it: itself or an earlier one.
// distance 0: points with equal coordinates. Otherwise each point goes to the nearest earlier one within the
// distance that stands for itself (of equals the first), so that no chain of points is drawn together.
[[nodiscard]] std::vector<std::uint32_t> weld_points(std::span<const Vec3> points, double distance);

}  // namespace quarry
