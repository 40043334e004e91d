// Feeds arbitrary bytes to the reader of one format of lines, QUARRY_FUZZ_EXTENSION: it must return lines of
// finite points, or points alone, or throw quarry::Error.
#include <cmath>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/line_reader.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using quarry::fuzz::require;
  static const quarry::fuzz::InputFile file(QUARRY_FUZZ_EXTENSION);
  quarry::log::set_level(quarry::log::Level::kQuiet);
  try {
    const quarry::LineSet lines = quarry::read_lines({file.write(data, size)});
    require(!lines.lines.empty() || !lines.points.empty());
    for (const auto& line : lines.lines) {
      require(line.points.size() != 1);
      require(line.heights.empty() || line.heights.size() == line.points.size());
      for (const quarry::Vec2 p : line.points) require(std::isfinite(p.x) && std::isfinite(p.y));
    }
    for (const quarry::InputPoint& point : lines.points)
      require(std::isfinite(point.place.x) && std::isfinite(point.place.y));
  } catch (const quarry::Error&) {
    // Refused in the way that the user sees.
  }
  return 0;
}
