#include "io/lines/companion_file.hpp"

#include <algorithm>
#include <filesystem>

#include <cctype>

#include "io/lower_case.hpp"

namespace quarry {

std::string companion_file(const std::string& path, const std::string& extension) {
  std::string capitals = extension;
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const std::string& each : {extension, capitals}) {
    const std::filesystem::path beside = std::filesystem::path(path).replace_extension(each);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored)) return beside.string();
  }
  return {};
}

std::vector<std::string> files_read_with(const std::string& path) {
  std::vector<std::string> files{path};
  // Some formats are folders (.gdb).
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure)) {
    files.clear();
    for (std::filesystem::recursive_directory_iterator at(path, failure), end; !failure && at != end;
         at.increment(failure))
      if (at->is_regular_file(failure)) files.push_back(at->path().string());
    std::ranges::sort(files);
    return files;
  }
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  const auto add = [&](const std::string& beside) {
    if (std::string file = companion_file(path, beside); !file.empty()) files.push_back(std::move(file));
  };
  if (extension == ".poly") add(".node");
  if (extension == ".shp")
    for (const char* const part : {".shx", ".dbf", ".cpg", ".prj"}) add(part);
  return files;
}

}  // namespace quarry
