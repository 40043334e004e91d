// Rasters in the formats that are read.
#pragma once

#include <string>

#include "engine/base/progress.hpp"
#include "engine/geometry/raster.hpp"

namespace quarry {

// Whether the extension is that of a raster: .asc, or .tif, .tiff and .vrt, which GDAL's gdal_translate
// reads.
[[nodiscard]] bool is_raster_file(const std::string& path);

// The first band of a raster. Throws Error(kInput) as read_asc does, and where GDAL fails or is not
// installed.
[[nodiscard]] Raster read_raster(const std::string& path, const Progress& progress = {});

}  // namespace quarry
