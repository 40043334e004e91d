// Feeds arbitrary bytes to the reader of Shapefiles as its .shp, .shx and .dbf: two numbers of two bytes, the
// sizes of the first two, and then all three. It must return lines of finite points or throw quarry::Error.
#include <algorithm>
#include <cmath>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/line_reader.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using quarry::fuzz::require;
  static const quarry::fuzz::InputFile shapes(".shp"), index(".shx"), table(".dbf");
  quarry::log::set_level(quarry::log::Level::kQuiet);
  if (size < 4) return 0;
  const std::size_t first = std::min<std::size_t>(data[0] + 256U * data[1], size - 4);
  const std::size_t second = std::min<std::size_t>(data[2] + 256U * data[3], size - 4 - first);
  const std::string& path = shapes.write(data + 4, first);
  index.write(data + 4 + first, second);
  table.write(data + 4 + first + second, size - 4 - first - second);
  try {
    const quarry::LineSet lines = quarry::read_lines({path});
    for (const auto& line : lines.lines)
      for (const quarry::Vec2 p : line.points) require(std::isfinite(p.x) && std::isfinite(p.y));
  } catch (const quarry::Error&) {
    // Refused in the way that the user sees.
  }
  return 0;
}
