// What a file says about its coordinates.
#pragma once

#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// definition: WKT of any version, "EPSG:n", "urn:ogc:def:crs:...", a PROJ string; "" for none. One that PROJ
// does not know is kept, and taken as plane.
[[nodiscard]] CoordinateSystem describe_system(std::string definition);

}  // namespace quarry
