#include "io/gdal_program.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/child_process.hpp"
#include "io/mapped_file.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

// The first error that GDAL told, or its last row.
std::string reason_in(const std::string& path) {
  const MappedFile file(path);
  TextRows rows(file.text());
  std::string reason;
  while (rows.next()) {
    const std::string_view row = trimmed(rows.row());
    if (row.empty()) continue;
    reason = row.substr(0, 300);
    if (row.starts_with("ERROR")) break;
  }
  return reason;
}

}  // namespace

std::string gdal_path(const std::string& path) {
  const std::filesystem::path whole(path);
  return whole.is_absolute() ? path : (std::filesystem::path(".") / whole).string();
}

void run_gdal(std::vector<std::string> words, const ScratchFolder& folder, const std::string& out,
              const std::string& source, const std::string& instead, const Progress& progress) {
  ChildStart process;
  process.words = std::move(words);
  process.out = folder.file(out);
  process.err = folder.file("messages");
  const std::optional<int> status = run_program(process, progress);
  if (!status)
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: no reader for '{}' files without GDAL's {}: install it (Debian: apt-get "
                    "install gdal-bin), or save it as {}",
                    source, std::filesystem::path(source).extension().string(), process.words[0], instead));
  if (*status == 0) return;
  std::string reason = reason_in(process.err);
  if (reason.empty()) reason = reason_in(process.out);
  if (reason.empty()) reason = fmt::format("exit status {}", *status);
  throw Error(ErrorKind::kInput, fmt::format("{}: GDAL ({}) cannot read it: {}; read without GDAL: {}",
                                             source, process.words[0], reason, instead));
}

}  // namespace quarry
