// Where a chain of edges bends, in the plane or in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

// The places where a polyline must be cut so that each stretch between two cuts is straight: all its points
// lie within the tolerance of the segment between its ends, and follow one another along that. Ascending,
// with the first and the last point. A polyline whose ends are the same point is cut in between as well.
// Method: Douglas & Peucker 1973, with cuts also where a stretch turns back.
[[nodiscard]] std::vector<std::uint32_t> find_bends(std::span<const Vec2> points, double tolerance);
[[nodiscard]] std::vector<std::uint32_t> find_bends(std::span<const Vec3> points, double tolerance);

}  // namespace quarry
