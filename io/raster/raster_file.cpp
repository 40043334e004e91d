#include "io/raster/raster_file.hpp"

#include <filesystem>

#include "engine/base/error.hpp"
#include "io/gdal_program.hpp"
#include "io/lower_case.hpp"
#include "io/raster/asc_reader.hpp"

namespace quarry {
namespace {

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

bool is_read_by_gdal(const std::string& extension) {
  return extension == ".tif" || extension == ".tiff" || extension == ".vrt";
}

}  // namespace

bool is_raster_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".asc" || is_read_by_gdal(extension);
}

Raster read_raster(const std::string& path, const Progress& progress) {
  if (!is_read_by_gdal(extension_of(path))) return read_asc(path);
  if (!std::filesystem::exists(path))
    throw Error(ErrorKind::kInput, path + ": cannot be read: No such file or directory");
  const ScratchFolder folder;
  const std::string text = folder.file("raster.asc");
  // As many digits as doubles have.
  run_gdal({"gdal_translate", "-q", "-b", "1", "-of", "AAIGrid", "-co", "SIGNIFICANT_DIGITS=17",
            gdal_path(path), text},
           folder, "said", path, "an ESRI ASCII raster (.asc)", progress);
  return read_asc(text, path);
}

}  // namespace quarry
