#include "io/lines/line_format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/input_text.hpp"
#include "io/lines/csv_columns.hpp"
#include "io/lines/csv_reader.hpp"
#include "io/lines/csv_rows.hpp"
#include "io/lines/fracpaq_reader.hpp"
#include "io/lines/geojson_reader.hpp"
#include "io/lines/number_row.hpp"
#include "io/lines/pline_reader.hpp"
#include "io/lines/poly_reader.hpp"
#include "io/lines/shapefile_reader.hpp"
#include "io/lines/wkt_geometry.hpp"
#include "io/lines/wkt_reader.hpp"
#include "io/lower_case.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

constexpr LineFormat kGeojson{"GeoJSON", read_geojson_lines};
constexpr LineFormat kWkt{"WKT", read_wkt_lines};
constexpr LineFormat kCsv{"CSV", read_csv_lines};
constexpr LineFormat kFracpaq{"FracPaQ", read_fracpaq_lines};
constexpr LineFormat kPoly{"Triangle .poly", read_poly_lines};
constexpr LineFormat kShapefile{"Shapefile", read_shapefile_lines};
constexpr LineFormat kPline{"GOCAD .pl", read_pline_lines};

struct Extension {
  std::string_view text;
  const LineFormat* format;  // null: what is in the file decides
};

constexpr std::array kExtensions{
    Extension{".geojson", &kGeojson}, Extension{".json", &kGeojson}, Extension{".shp", &kShapefile},
    Extension{".wkt", &kWkt},         Extension{".poly", &kPoly},    Extension{".pl", &kPline},
    Extension{".csv", nullptr},       Extension{".tsv", nullptr},    Extension{".txt", nullptr},
    Extension{".dat", nullptr},       Extension{".xy", nullptr},     Extension{".xyz", nullptr}};

const Extension* find_extension(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  const auto known = std::ranges::find(kExtensions, extension, &Extension::text);
  return known == kExtensions.end() ? nullptr : &*known;
}

bool is_whole(double value, double lowest, double highest) {
  return value >= lowest && value <= highest && std::trunc(value) == value;
}

// "vertices dimension attributes markers", then a vertex of as many numbers as that says.
bool looks_like_poly(const std::vector<double>& first, const std::vector<double>& second) {
  return first.size() == 4 && is_whole(first[0], 1, 1e9) && first[1] == 2 && is_whole(first[2], 0, 100) &&
         is_whole(first[3], 0, 1) && !second.empty() && is_whole(second[0], 0, 1) &&
         static_cast<double>(second.size()) == 3 + first[2] + first[3];
}

// Names of columns. Words between blanks are anything, unless some are names that we know.
bool looks_like_header(std::string_view row) {
  const char delimiter = find_delimiter(row);
  if (delimiter == 0) return lower_case(row) == "wkt";
  if (delimiter != ' ') return true;
  CsvRows rows(row, delimiter);
  return rows.next() && find_csv_columns(rows.cells()).holds_lines();
}

const LineFormat* format_of_table(std::string_view text) {
  TextRows rows(text);
  std::array<NumberRow, 2> first;
  std::size_t count = 0;
  while (count < first.size() && rows.next()) {
    const std::string_view row = trimmed(rows.row());
    if (row.empty() || row.front() == '#') continue;
    read_number_row(row, first[count]);
    if (count == 0 && !first[0].problem.empty()) return looks_like_header(row) ? &kCsv : nullptr;
    ++count;
  }
  if (count == 0) return nullptr;
  if (looks_like_poly(first[0].numbers, first[1].numbers)) return &kPoly;
  return first[0].numbers.size() < 4 ? &kCsv : &kFracpaq;
}

}  // namespace

const LineFormat* line_format_of_extension(const std::string& path) {
  const Extension* extension = find_extension(path);
  return extension == nullptr ? nullptr : extension->format;
}

bool content_decides(const std::string& path) {
  const Extension* extension = find_extension(path);
  if (extension != nullptr) return extension->format == nullptr;
  return path == kStandardInput || !std::filesystem::path(path).has_extension();
}

bool is_read_by_ogr(const std::string& path) {
  return line_format_of_extension(path) == nullptr && !content_decides(path);
}

const LineFormat* line_format_of_text(std::string_view text) {
  const auto space = [](unsigned char c) { return std::isspace(c) != 0; };
  const auto begin = std::ranges::find_if_not(text, space);
  text.remove_prefix(static_cast<std::size_t>(begin - text.begin()));
  if (text.empty() || text.find('\0') != std::string_view::npos) return nullptr;
  if (text.front() == '{' || text.front() == '[') return &kGeojson;
  if (text.starts_with("GOCAD")) return &kPline;
  // After comments.
  std::string_view content = text;
  while (content.starts_with('#')) {
    content.remove_prefix(std::min(content.find_first_of("\r\n"), content.size()));
    content.remove_prefix(
        static_cast<std::size_t>(std::ranges::find_if_not(content, space) - content.begin()));
  }
  // A table whose first column is called so starts as a geometry does, too.
  if (starts_as_wkt(content) &&
      content.substr(0, content.find_first_of("\r\n")).find('(') != std::string_view::npos)
    return &kWkt;
  return format_of_table(text);
}

std::string readable_line_extensions() {
  std::vector<std::string_view> known;
  for (const Extension& extension : kExtensions) known.push_back(extension.text);
  return fmt::format("{}", fmt::join(known, ", "));
}

}  // namespace quarry
