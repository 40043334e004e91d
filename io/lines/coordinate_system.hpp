// What a file says about its coordinates.
#pragma once

#include <cstdint>
#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// definition: WKT of any version, "EPSG:n", "urn:ogc:def:crs:...", a PROJ string; "" for none. One that PROJ
// does not know is kept, and taken as plane.
[[nodiscard]] CoordinateSystem describe_system(std::string definition);

// Whether two definitions mean the same, but for the order of axes; false where PROJ does not know one of
// them and their texts differ.
[[nodiscard]] bool same_system(const std::string& a, const std::string& b);

// The name of a system as a URN ("urn:ogc:def:crs:EPSG::3067"), by what it is called or, for WKT that does
// not say, by what it means; "" where PROJ finds none.
[[nodiscard]] std::string system_urn(const std::string& definition);

// Whether the lines of a file look like longitude and latitude: all within 180 and 90 degrees, some number
// with more than three decimals, and the box of all at least twice its longer side away from (0, 0), near
// which plane coordinates of a site begin.
[[nodiscard]] bool look_like_degrees(const LineSet& lines, std::uint32_t file);

// Brings the lines of all files to the plane of the UTM zone (WGS 84) in which the middle of the files in
// degrees lies, and says which that is; lines wider than 180 degrees of longitude lie across the
// antimeridian. extra: lines that go with them, an outline. Throws Error(kInput) where a file does not say
// what its coordinates are, where PROJ does not know it, for points in degrees more than 20 degrees of
// longitude from the middle of the zone, and for points that have no place in the plane.
[[nodiscard]] std::string project_to_utm(LineSet& lines, LineSet* extra);

}  // namespace quarry
