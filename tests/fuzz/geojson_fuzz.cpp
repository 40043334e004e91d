// Feeds arbitrary bytes to the GeoJSON reader: it must return lines of finite points or throw quarry::Error.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

#include <unistd.h>

#include "engine/base/error.hpp"
#include "io/lines/line_reader.hpp"

namespace {

// The reader takes paths: one file a process, in memory where the system has /dev/shm.
const std::string& input_path() {
  static const std::string path = [] {
    std::atexit([] { unlink(input_path().c_str()); });
    const std::string folder = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    return folder + "/quarry_fuzz_" + std::to_string(getpid()) + ".geojson";
  }();
  return path;
}

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream(input_path(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const quarry::LineSet lines = quarry::read_lines({input_path()});
    require(!lines.lines.empty());
    for (const auto& line : lines.lines)
      for (const quarry::Vec2 p : line.points) require(std::isfinite(p.x) && std::isfinite(p.y));
  } catch (const quarry::Error&) {
    // Refused in the way that the user sees.
  }
  return 0;
}
