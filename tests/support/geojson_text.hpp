// Lines as the text of a file.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/geometry/vec.hpp"

namespace quarry {

using Polyline = std::vector<Vec2>;

// Lines as GeoJSON text, with the fewest digits that read as the same numbers.
inline std::string geojson_text(const std::vector<Polyline>& lines) {
  std::string text = R"({"type": "FeatureCollection", "features": [)";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += i == 0 ? "" : ",";
    text += R"({"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [)";
    for (std::size_t k = 0; k < lines[i].size(); ++k)
      text += fmt::format("{}[{}, {}]", k == 0 ? "" : ",", lines[i][k].x, lines[i][k].y);
    text += "]}}";
  }
  return text + "]}";
}

}  // namespace quarry
