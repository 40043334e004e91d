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

// Why there is no mesh: where elements came out inverted, flat or upside down; one place at least.
[[nodiscard]] std::string invalid_note(const std::vector<TightPlace>& invalid);

}  // namespace quarry
