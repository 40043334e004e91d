// Elementary functions made of +, -, *, / and square roots alone, which IEEE 754 rounds in one way: models
// that are drawn with them have the same bytes on every machine. The C library's own differ in the last bit
// from one version to the next. Errors are a few units in the last place.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry::portable {

// The natural logarithm of a finite number above 0.
[[nodiscard]] double log(double x);
// e^x for |x| below 700.
[[nodiscard]] double exp(double x);
// base^exponent for a base above 0.
[[nodiscard]] double power(double base, double exponent);
// The unit vector (cos, sin) of an angle in radians, of at most 1e6.
[[nodiscard]] Vec2 direction(double radians);

}  // namespace quarry::portable
