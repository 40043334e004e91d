// What a job on a surface tells its user, as one line each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surface/repair/repair.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// That most rims of a repaired surface lie next to others, and which distance welds them; none where they do
// not.
[[nodiscard]] std::optional<std::string> crack_note(const RepairedSurface& repaired);

// Where elements are smaller than wanted, and how small (input units); none where nothing limits them.
[[nodiscard]] std::optional<std::string> limit_note(const SurfaceSizes::Limited& limited);

// That edges of rims which stay as they are, up to so long (input units), are too long for the elements.
[[nodiscard]] std::string kept_rim_note(double longest);

// Why there is no mesh: where elements came out inverted, flat or upside down; one place at least. kept_rim:
// the longest edge of rims that stay as they are (input units), where it is too long for the elements; else
// 0.
[[nodiscard]] std::string invalid_note(const std::vector<TightPlace>& invalid, double kept_rim);

}  // namespace quarry
