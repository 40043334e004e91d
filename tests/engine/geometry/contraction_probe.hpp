// Plain formulas compiled for a processor with fused multiply-add: what contraction would change.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

double probe_cross(Vec2 u, Vec2 v);

// The orientation of a, b, c as one writes it without thinking; not exact, but antisymmetric unless
// contracted.
double probe_naive_orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace quarry
