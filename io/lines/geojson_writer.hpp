// Cleaned lines, and points, as GeoJSON.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "engine/geometry/line_set.hpp"

namespace quarry {

struct GeojsonWriteOptions {
  // The lines before cleaning: a chain gets the name, set, material and aperture of the first of its lines
  // that has any.
  const LineSet* input = nullptr;
  // The member "crs"; "" for none.
  std::string system;
  // The node of each input point, or none.
  IdVector<PointId, NodeId> points;
};

// Writes one LineString for each longest chain of pieces that bear the same line numbers and are of the same
// kind, with the properties "lines" (numbers of the input lines that run along it, ascending) and "kind"
// ("interior" or "outline"). A chain ends where three pieces meet. Nodes of input points are Points with the
// property "points", and with the name, set and material of the first of those that has any. Coordinates are
// written so that reading gives the same bits. Throws Error(kOutput); the file appears whole or not at all.
void write_lines_geojson(const std::string& path, const NodedLines& lines,
                         const GeojsonWriteOptions& options = {});

// Writes each point as one feature, in order. properties(index) gives the members of its properties as JSON
// text ("\"class\":\"X\""); it is called by many threads. system: the member "crs"; "" for none. Coordinates
// and the file as above.
void write_points_geojson(const std::string& path, std::span<const Vec2> points,
                          const std::function<std::string(std::size_t)>& properties,
                          const std::string& system = {});

}  // namespace quarry
