#include "io/lines/ogr_layers.hpp"

#include "io/text_rows.hpp"

namespace quarry {

std::vector<OgrLayer> parse_ogr_layers(std::string_view text) {
  constexpr std::string_view kName = "Layer name: ", kSystem = "Layer SRS WKT:";
  constexpr std::string_view kAfterSystem = "Data axis to CRS axis mapping";
  std::vector<OgrLayer> layers;
  bool in_system = false;
  TextRows rows(text);
  while (rows.next()) {
    const std::string_view row = rows.row();
    if (row.starts_with(kName)) {
      layers.push_back({std::string(row.substr(kName.size())), "", true});
      in_system = false;
    } else if (layers.empty()) {
      continue;
    } else if (row.starts_with(kSystem)) {
      in_system = true;
    } else if (in_system && !row.starts_with(kAfterSystem) && row != "(unknown)") {
      layers.back().system += trimmed(row);
    } else {
      in_system = false;
      if (row == "Geometry: None") layers.back().geometry = false;
    }
  }
  return layers;
}

}  // namespace quarry
