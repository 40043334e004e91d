// How bad the faces may be that clean-up leaves in the place of those of an input.
#pragma once

#include <algorithm>

#include "kernels/quality/summary.hpp"

namespace quarry {

// A mesh without bad faces gets none for the sake of its valences: the smallest scaled Jacobian that it has,
// but at least `least`, and no more than 0.6, which would leave clean-up nothing to do.
[[nodiscard]] inline double clean_up_floor(const QualitySummary& before, double least) {
  return std::clamp(before.all.scaled_jacobian.min, least, 0.6);
}

}  // namespace quarry
