// What GDAL's ogrinfo says of a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quarry {

struct OgrLayer {
  std::string name;
  std::string system;    // its coordinate system as WKT in one row; "" if it has none
  bool geometry = true;  // false: a table without geometries
};

// The layers that `ogrinfo -so -al` lists.
[[nodiscard]] std::vector<OgrLayer> parse_ogr_layers(std::string_view text);

}  // namespace quarry
