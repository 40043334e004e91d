#include "tests/engine/geometry/contraction_probe.hpp"

namespace quarry {

double probe_cross(Vec2 u, Vec2 v) { return cross(u, v); }

double probe_naive_orientation(Vec2 a, Vec2 b, Vec2 c) { return cross(a - c, b - c); }

}  // namespace quarry
