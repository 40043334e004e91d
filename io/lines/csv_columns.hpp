// What the columns of a table of lines mean, by the words of its first row.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace quarry {

struct CsvColumns {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t wkt = kNone;
  std::size_t x = kNone, y = kNone, z = kNone;
  std::size_t line = kNone;                                     // which line a row's point belongs to
  std::size_t point = kNone;                                    // the name of a row that is a point by itself
  std::vector<std::pair<std::size_t, std::string>> attributes;  // column and name of the attribute
  bool degrees = false;                                         // x and y are called longitude and latitude

  [[nodiscard]] bool holds_lines() const { return wkt != kNone || (x != kNone && y != kNone); }
};

// In either case of letters: wkt, geometry, geom, ...; x, easting, lon, ...; y, northing, lat, ...; z,
// elevation,
// ...; line, line_id, trace, fracture, fault, feature, fid, id, ...; well, point, sensor, ... (all words
// stand in the source). Where several fit, the first word of these lists that a column has.
[[nodiscard]] CsvColumns find_csv_columns(const std::vector<std::string>& header);

}  // namespace quarry
