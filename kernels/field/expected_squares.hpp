// How many elements a size field means.
#pragma once

#include <functional>

#include "engine/geometry/box.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

// The integral of 1 / size^2 over the part of the box for which inside(place) holds (all of it without the
// function): about how many squares of the wanted sizes fill it. Cells that are halved until they are no
// larger than four sizes are counted by their middles, which is as exact as slopes of up to one allow.
// Counting ends early once there are more than `most`, which bounds the work.
[[nodiscard]] double expected_squares(const SizeField& field, const Box2& box, double most,
                                      const std::function<bool(Vec2)>& inside = {});

}  // namespace quarry
