// GDAL's programs, run as processes where they are installed: its libraries are not linked, for some of what
// they bring is under the GPL.
#pragma once

#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "io/scratch_folder.hpp"

namespace quarry {

// A file as GDAL's programs are given it: no name is taken for an option, or for a database.
[[nodiscard]] std::string gdal_path(const std::string& path);

// Runs one of them; what it prints is in the file `out` of the folder afterwards. source: the file that it
// reads, instead: what can be read without it, both for messages. Throws Error(kInput), "source: ...", with
// GDAL's reason where it fails, and with what to install where it is not there.
void run_gdal(std::vector<std::string> words, const ScratchFolder& folder, const std::string& out,
              const std::string& source, const std::string& instead, const Progress& progress);

}  // namespace quarry
