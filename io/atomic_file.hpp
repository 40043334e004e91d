// Output files that appear whole or not at all: everything that writes a file writes through here.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

// Writes to a temporary file beside the target; commit() renames it over the target, and a file that is not
// committed leaves no trace. Every failure is Error(kOutput) with the path and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  // Replaces bytes written before, from `offset` on: for tables whose content is known only once what follows
  // them has been written.
  void overwrite(std::size_t offset, std::span<const std::byte> bytes);
  // Flushes, closes and renames. Nothing may be written afterwards.
  void commit();

  [[nodiscard]] const std::string& path() const { return path_; }
  // Where the file lies before commit(), for libraries that write files by themselves: such a file is written
  // by them alone.
  [[nodiscard]] const std::string& temporary() const { return temporary_; }
  // Bytes written so far.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void flush();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string target_;  // path_ behind symbolic links
  std::string temporary_;
  std::vector<std::byte> buffer_;
  std::size_t size_ = 0;
  int descriptor_ = -1;
};

// A temporary file that a process left behind which was killed: the name of what it was to become, and the
// number of the process.
struct PartialFile {
  std::string target;
  int process = 0;
};

// What the name of such a file says; none for the names of other files.
[[nodiscard]] std::optional<PartialFile> parse_partial_name(std::string_view name);

// Writes a whole file at once.
void write_file(const std::string& path, std::string_view text);

}  // namespace quarry
