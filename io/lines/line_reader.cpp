#include "io/lines/line_reader.hpp"

#include <algorithm>
#include <string_view>

#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/input_text.hpp"
#include "io/lines/line_format.hpp"

namespace quarry {
namespace {

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

[[noreturn]] void fail(const std::string& path, const std::string& message) {
  throw Error(ErrorKind::kInput, fmt::format("{}: {}", input_name(path), message));
}

const LineFormat& format_of(const std::string& path, std::string_view text) {
  if (const LineFormat* format = line_format_of_extension(path)) return *format;
  if (const LineFormat* format = line_format_of_text(text)) return *format;
  fail(path,
       "its first rows look like no format of lines that is known: GeoJSON, WKT, CSV with names of columns "
       "(x,y,line or wkt), FracPaQ, Triangle .poly or GOCAD .pl");
}

void read_file(const std::string& path, const OgrOptions& options, LineSet& lines) {
  LineSource source;
  source.name = input_name(path);
  source.file = static_cast<std::uint32_t>(lines.files.size());
  lines.files.push_back(source.name);
  lines.systems.emplace_back();
  if (is_read_by_ogr(path)) return read_ogr_lines(source, options, lines);
  const InputText input(path);
  source.text = without_byte_order_mark(input.text());
  if (std::ranges::all_of(source.text, [](unsigned char c) { return std::isspace(c) != 0; }))
    fail(path, "the file is empty");
  format_of(path, source.text).read(source, lines);
}

}  // namespace

LineSet read_lines(const std::vector<std::string>& paths, const OgrOptions& options) {
  LineSet result;
  for (const std::string& path : paths) {
    const LineSetMark before = LineSetMark::of(result);
    read_file(path, options, result);
    if (result.lines.size() == before.lines && result.points.size() == before.points && paths.size() > 1)
      log::warn("{}: holds no lines and no points", input_name(path));
  }
  if (result.lines.empty() && result.points.empty())
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: no lines in the input; give a file with LineString, MultiLineString, Polygon, "
                    "MultiPolygon or Point features",
                    fmt::join(result.files, ", ")));
  return result;
}

}  // namespace quarry
