#include "pipeline/batch/folder_inputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/lines/line_format.hpp"
#include "io/lower_case.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/mesh_format.hpp"

namespace quarry {
namespace {

namespace fs = std::filesystem;

// GDAL reads these; of other extensions that we do not know it is not to be expected.
constexpr std::array<std::string_view, 8> kOgrExtensions = {".gpkg", ".dxf", ".gml", ".kml",
                                                            ".fgb",  ".gpx", ".tab", ".mif"};
// Parts of other files, whether these are there or not.
constexpr std::array<std::string_view, 9> kPartExtensions = {".dbf", ".shx", ".prj",  ".cpg", ".sbn",
                                                             ".sbx", ".qix", ".node", ".xml"};

bool begins_like_lines(const std::string& path) {
  constexpr std::size_t kBeginning = 1 << 16;
  try {
    const MappedFile file(path);
    return line_format_of_text(file.text().substr(0, kBeginning)) != nullptr;
  } catch (const Error&) {
    // The job will tell why.
    return true;
  }
}

bool is_model(const std::string& path) {
  if (line_format_of_extension(path) != nullptr || is_mesh_file(path)) return true;
  const std::string extension = lower_case(fs::path(path).extension().string());
  if (content_decides(path)) return begins_like_lines(path);
  return std::ranges::find(kOgrExtensions, extension) != kOgrExtensions.end();
}

bool is_part(const std::string& path) {
  const std::string extension = lower_case(fs::path(path).extension().string());
  return std::ranges::find(kPartExtensions, extension) != kPartExtensions.end();
}

}  // namespace

FolderInputs list_inputs(const std::string& folder) {
  FolderInputs found;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    std::error_code ignored;
    const std::string path = at->path().string();
    const std::string name = at->path().filename().string();
    if (name.starts_with('.') || !at->is_regular_file(ignored) || is_part(path)) continue;
    if (is_model(path))
      found.files.push_back(path);
    else
      found.passed_over.push_back(name);
  }
  if (failure) throw Error(ErrorKind::kInput, fmt::format("{}: {}", folder, failure.message()));
  std::ranges::sort(found.files);
  std::ranges::sort(found.passed_over);
  return found;
}

}  // namespace quarry
