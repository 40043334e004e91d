// Feeds arbitrary bytes to the readers of rasters in ESRI ASCII format and of points with values: each must
// return finite numbers or throw quarry::Error.
#include <cmath>

#include "engine/base/error.hpp"
#include "io/raster/asc_reader.hpp"
#include "io/raster/point_values.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using quarry::fuzz::require;
  static const quarry::fuzz::InputFile file(".asc");
  const std::string& path = file.write(data, size);
  try {
    static_cast<void>(quarry::read_asc(path));
  } catch (const quarry::Error&) {
    // Refused in the way that the user sees.
  }
  try {
    for (const quarry::PointValue& point : quarry::read_point_values(path))
      require(std::isfinite(point.at.x) && std::isfinite(point.at.y) && std::isfinite(point.value));
  } catch (const quarry::Error&) {
    // The same.
  }
  return 0;
}
