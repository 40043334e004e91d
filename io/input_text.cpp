#include "io/input_text.hpp"

#include <array>
#include <cstdio>
#include <cstring>

#include <cerrno>
#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

std::string read_standard_input() {
  std::string text;
  std::array<char, std::size_t{1} << 16> block;
  errno = 0;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), stdin))
    text.append(block.data(), count);
  if (std::ferror(stdin) != 0)
    throw Error(ErrorKind::kInput, fmt::format("standard input: cannot be read: {}", std::strerror(errno)));
  return text;
}

}  // namespace

InputText::InputText(const std::string& path) {
  if (path == kStandardInput) {
    static const std::string text = read_standard_input();
    text_ = text;
  } else {
    text_ = file_.emplace(path).text();
  }
}

std::string input_name(const std::string& path) { return path == kStandardInput ? "standard input" : path; }

}  // namespace quarry
