#include "io/scratch_folder.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <cerrno>
#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

ScratchFolder::ScratchFolder() {
  std::error_code failure;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
  path_ = ((failure ? std::filesystem::path("/tmp") : parent) / "quarry_XXXXXX").string();
  if (::mkdtemp(path_.data()) == nullptr)
    throw Error(ErrorKind::kOutput, fmt::format("{}: cannot be made: {}", path_, std::strerror(errno)));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace quarry
