// Lines as GeoJSON features with properties.
#pragma once

#include <functional>
#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Writes each line as one feature, in order: a LineString, or a Polygon where it is an outer ring.
// properties(line) gives the members of its properties as JSON text ("\"kind\":\"fault\""); it is called by
// many threads. Coordinates are written so that reading gives the same bits. Throws Error(kOutput); the file
// appears whole or not at all.
void write_features_geojson(const std::string& path, const LineSet& lines,
                            const std::function<std::string(LineId)>& properties);

}  // namespace quarry
