// The models in a folder.
#pragma once

#include <string>
#include <vector>

namespace quarry {

struct FolderInputs {
  std::vector<std::string> files;        // sorted by name
  std::vector<std::string> passed_over;  // names of files that are no models, sorted
};

// The files of lines and of surfaces in a folder, not in the folders below it: by their extension, and where
// that does not tell by how they begin. Parts of others (.dbf, .shx, .node and so on), and files and folders
// whose names begin with a point, are neither. Throws Error(kInput) where the folder cannot be read.
[[nodiscard]] FolderInputs list_inputs(const std::string& folder);

}  // namespace quarry
