// Files that belong to a file of lines: the parts of a Shapefile, the vertices of a .poly.
#pragma once

#include <string>
#include <vector>

namespace quarry {

// The file of the same name with another extension, in small letters or in capitals; "" if there is none.
[[nodiscard]] std::string companion_file(const std::string& path, const std::string& extension);

// All files that reading a file of lines reads, itself first.
[[nodiscard]] std::vector<std::string> files_read_with(const std::string& path);

}  // namespace quarry
