// Exact adaptive predicates on doubles: the sign is always right, barring overflow and underflow (which need
// coordinates that differ by less than about 1e-70 or more than 1e70). A floating-point filter answers nearly
// every call; the rest falls through to longer arithmetic (Shewchuk 1997). Built with contraction off.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

// > 0 if a, b, c turn left, < 0 if right, exactly 0 if they lie on one line.
// The magnitude is about twice the area.
[[nodiscard]] double orient2d(Vec2 a, Vec2 b, Vec2 c);

// > 0 if d lies below the plane through a, b, c (which seen from above turn left), < 0 above, 0 on it.
// The magnitude is about six times the volume.
[[nodiscard]] double orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// > 0 if d lies inside the circle through a, b, c (which turn left), < 0 outside, 0 on it.
[[nodiscard]] double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace quarry
