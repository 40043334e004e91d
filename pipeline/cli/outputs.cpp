#include "pipeline/cli/outputs.hpp"

#include <cstdio>
#include <cstring>
#include <filesystem>

#include <cerrno>
#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"

namespace quarry::cli {
namespace {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  const auto full = [&](const std::string& path) { return std::filesystem::weakly_canonical(path, ignored); };
  return full(a) == full(b) || std::filesystem::equivalent(a, b, ignored);
}

void require_writable(const std::string& path) {
  // A file that is not committed leaves no trace.
  const AtomicFile probe(path);
  if (::access(path.c_str(), F_OK) == 0 && ::access(path.c_str(), W_OK) != 0)
    throw Error(ErrorKind::kOutput, fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && same_file(outputs[i], input))
        throw Error(ErrorKind::kUsage,
                    fmt::format("{}: is an input as well; name another output", outputs[i]));
    for (std::size_t k = 0; k < i; ++k)
      if (!outputs[k].empty() && same_file(outputs[i], outputs[k]))
        throw Error(ErrorKind::kUsage, fmt::format("{}: two outputs have this name", outputs[i]));
    require_writable(outputs[i]);
  }
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Error(ErrorKind::kOutput,
                fmt::format("standard output: cannot be written: {}", std::strerror(errno)));
}

}  // namespace quarry::cli
