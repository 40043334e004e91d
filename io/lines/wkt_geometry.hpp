// One geometry in well-known text (OGC 06-103r4, with "SRID=n;" before it as PostGIS writes it).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/geometry/line_set.hpp"

namespace quarry {

struct WktGeometry {
  std::size_t end = 0;  // bytes of the text that it takes
  std::string system;   // "EPSG:n"; "" without SRID
  std::string problem;  // what is wrong at text[end]; "" if nothing is
};

// Whether a text starts as a geometry does, in either case of letters.
[[nodiscard]] bool starts_as_wkt(std::string_view text);

// Appends the lines of the geometry that the text starts with: LINESTRING, MULTILINESTRING, POLYGON,
// MULTIPOLYGON, also within GEOMETRYCOLLECTIONs; points are passed over. Z is the height; M is passed over.
// Curves and what is no geometry are problems.
[[nodiscard]] WktGeometry read_wkt_geometry(std::string_view text, std::uint32_t file, std::uint32_t feature,
                                            LineSet& lines);

}  // namespace quarry
