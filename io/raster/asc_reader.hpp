// Reads rasters in ESRI ASCII format (.asc): ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter,
// cellsize and, if need be, NODATA_value, in any order and case; then the values row by row from the top.
#pragma once

#include <string>

#include "engine/geometry/raster.hpp"

namespace quarry {

// Throws Error(kInput), "path:line: ...", for a header that lacks something or makes no sense, for a value
// that is no finite number, with its row and column (from 1, from the top left), and for too few or too many
// values. name: of the file in messages, if not its path.
[[nodiscard]] Raster read_asc(const std::string& path, const std::string& name = {});

}  // namespace quarry
