#include "io/lines/line_reader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/geojson_reader.hpp"

namespace quarry {
namespace {

struct LineFormat {
  std::string_view extension;
  void (*read)(const std::string& path, std::uint32_t file, LineSet& lines);
};

constexpr std::array kFormats{LineFormat{".geojson", read_geojson_lines},
                              LineFormat{".json", read_geojson_lines}};

const LineFormat& format_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const LineFormat& format : kFormats)
    if (format.extension == extension) return format;
  std::vector<std::string_view> known;
  for (const LineFormat& format : kFormats) known.push_back(format.extension);
  throw Error(ErrorKind::kInput, fmt::format("{}: no reader for lines in '{}' files; supported: {}", path,
                                             extension, fmt::join(known, ", ")));
}

}  // namespace

LineSet read_lines(const std::vector<std::string>& paths) {
  LineSet result;
  for (const std::string& path : paths) {
    const auto file = static_cast<std::uint32_t>(result.files.size());
    const std::size_t before = result.lines.size();
    const LineFormat& format = format_of(path);
    result.files.push_back(path);
    format.read(path, file, result);
    if (result.lines.size() == before && paths.size() > 1) log::warn("{}: holds no lines", path);
  }
  if (result.lines.empty())
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: no lines in the input; give a file with LineString, MultiLineString, Polygon "
                    "or MultiPolygon features",
                    fmt::join(paths, ", ")));
  return result;
}

}  // namespace quarry
