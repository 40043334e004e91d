#include "io/lines/csv_columns.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "io/lines/line_attributes.hpp"
#include "io/lower_case.hpp"

namespace quarry {
namespace {

using Words = std::span<const std::string_view>;

constexpr auto kWkt =
    std::to_array<std::string_view>({"wkt", "geometry", "geom", "the_geom", "wkt_geom", "shape"});
constexpr auto kX =
    std::to_array<std::string_view>({"x", "easting", "east", "point_x", "x_coord", "xcoord", "e"});
constexpr auto kY =
    std::to_array<std::string_view>({"y", "northing", "north", "point_y", "y_coord", "ycoord", "n"});
constexpr auto kLongitude = std::to_array<std::string_view>({"longitude", "lon", "long", "lng"});
constexpr auto kLatitude = std::to_array<std::string_view>({"latitude", "lat"});
constexpr auto kZ = std::to_array<std::string_view>({"z", "elevation", "height", "altitude", "point_z"});
constexpr auto kLine = std::to_array<std::string_view>(
    {"line",     "line_id",     "lineid",  "line id",  "line_no",  "lineno",      "line_number", "trace",
     "trace_id", "trace id",    "traceid", "trace_no", "polyline", "polyline_id", "feature",     "feature_id",
     "fracture", "fracture_id", "fault",   "fault_id", "fid",      "objectid",    "id",          "part"});

constexpr auto kPoint =
    std::to_array<std::string_view>({"well", "well_id", "well_name", "borehole", "borehole_id", "point",
                                     "point_id", "sensor", "sensor_id", "station", "station_id"});

std::size_t find(const std::vector<std::string>& header, Words words) {
  for (const std::string_view word : words)
    if (const auto at = std::ranges::find(header, word); at != header.end())
      return static_cast<std::size_t>(at - header.begin());
  return CsvColumns::kNone;
}

}  // namespace

CsvColumns find_csv_columns(const std::vector<std::string>& header) {
  std::vector<std::string> words;
  for (const std::string& cell : header) words.push_back(lower_case(cell));
  CsvColumns columns;
  columns.wkt = find(words, kWkt);
  columns.x = find(words, kX);
  columns.y = find(words, kY);
  if (columns.x == CsvColumns::kNone && columns.y == CsvColumns::kNone) {
    columns.x = find(words, kLongitude);
    columns.y = find(words, kLatitude);
    columns.degrees = columns.holds_lines() && columns.wkt == CsvColumns::kNone;
  }
  columns.z = find(words, kZ);
  columns.line = find(words, kLine);
  if (columns.wkt == CsvColumns::kNone) columns.point = find(words, kPoint);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (AttributeCollector::knows(words[i])) columns.attributes.emplace_back(i, words[i]);
  return columns;
}

}  // namespace quarry
