// Stretches of a raw line: from one parameter to another, where parameter i + f lies the share f along
// segment i. A raw line of one point is that point at any parameter.
#pragma once

#include <span>

#include "engine/geometry/vec.hpp"

namespace quarry::linework {

[[nodiscard]] Vec2 raw_point(std::span<const Vec2> line, double at);

// The parameter within [from, to] of the point of the stretch nearest to p; the smallest of equals.
[[nodiscard]] double nearest_parameter(std::span<const Vec2> line, double from, double to, Vec2 p);

// The largest distance of a point of the stretch from the segment ab, and of a from its beginning and b from
// its end: no point of the segment is farther from the stretch than that either.
[[nodiscard]] double deviation(std::span<const Vec2> line, double from, double to, Vec2 a, Vec2 b);

// The parameter of the raw vertex strictly within the stretch that is farthest from the segment ab; `from` if
// there is none.
[[nodiscard]] double farthest_vertex(std::span<const Vec2> line, double from, double to, Vec2 a, Vec2 b);

// The parameter reached by going a length along the line from `from` towards `to`; `to` if that comes first.
[[nodiscard]] double advance(std::span<const Vec2> line, double from, double to, double along);

// Length of the stretch.
[[nodiscard]] double stretch_length(std::span<const Vec2> line, double from, double to);

}  // namespace quarry::linework
