#include "io/lines/wkt_reader.hpp"

#include <algorithm>

#include <cctype>

#include "io/lines/coordinate_system.hpp"
#include "io/lines/wkt_geometry.hpp"

namespace quarry {
namespace {

// The next byte that is no space, no comment and no ";" between geometries.
std::size_t next_geometry(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == '#')
      at = std::min(text.find_first_of("\r\n", at), text.size());
    else if (std::isspace(static_cast<unsigned char>(text[at])) != 0 || text[at] == ';')
      ++at;
    else
      break;
  }
  return at;
}

// "\r\n" and "\r" alone end rows too.
std::size_t row_of(std::string_view text, std::size_t at) {
  std::size_t row = 1;
  for (std::size_t i = 0; i < at; ++i)
    if (text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'))) ++row;
  return row;
}

}  // namespace

void read_wkt_lines(const LineSource& source, LineSet& lines) {
  std::string system;
  std::uint32_t feature = 0;
  for (std::size_t at = next_geometry(source.text, 0); at < source.text.size();
       at = next_geometry(source.text, at)) {
    const WktGeometry geometry = read_wkt_geometry(source.text.substr(at), source.file, feature++, lines);
    at += geometry.end;
    if (!geometry.problem.empty()) source.fail_at(row_of(source.text, at), geometry.problem);
    if (!geometry.system.empty()) system = geometry.system;
  }
  lines.systems[source.file] = describe_system(system);
}

}  // namespace quarry
