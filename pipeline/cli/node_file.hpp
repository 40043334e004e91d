// The nodes of cleaned lines, as fracture people count them, as a file of points.
#pragma once

#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry::cli {

// Writes GeoJSON: a Point for each node that has a class (kernels/linework/node_classes.hpp), with the
// properties "class" ("I", "Y", "X" or "E"), "pieces" (how many interior ones end there) and "lines" (the
// numbers of the input lines that these bear, ascending). system: as of write_points_geojson. Throws
// Error(kOutput).
void write_node_file(const std::string& path, const NodedLines& lines, const std::string& system);

}  // namespace quarry::cli
