// Which format a file of lines is in: by the extension of its name, or by its first bytes.
#pragma once

#include <string>
#include <string_view>

#include "io/lines/line_source.hpp"

namespace quarry {

struct LineFormat {
  std::string_view name;  // as people call it
  void (*read)(const LineSource& source, LineSet& lines);
};

// The format that the extension alone tells (".geojson", ".wkt", ...; in either case of letters), or null.
[[nodiscard]] const LineFormat* line_format_of_extension(const std::string& path);

// Whether what is in the file decides: for ".txt", ".csv" and the like, names without an extension, and
// standard input.
[[nodiscard]] bool content_decides(const std::string& path);

// Whether neither tells: GDAL's ogr2ogr may know the format.
[[nodiscard]] bool is_read_by_ogr(const std::string& path);

// The format that the text looks like, or null.
[[nodiscard]] const LineFormat* line_format_of_text(std::string_view text);

// All extensions that are read, for messages: ".geojson, .json, ...".
[[nodiscard]] std::string readable_line_extensions();

}  // namespace quarry
