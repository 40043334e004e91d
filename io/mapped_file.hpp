// The bytes of an input file, mapped and not copied.
#pragma once

#include <string>
#include <string_view>

namespace quarry {

class MappedFile {
 public:
  // Throws Error(kInput) with the system's reason.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::string_view text() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace quarry
