// The bytes of an input that people name: a file, or "-" for standard input.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/mapped_file.hpp"

namespace quarry {

inline constexpr std::string_view kStandardInput = "-";

class InputText {
 public:
  // Standard input is read once, to its end, and kept: each later use sees the same bytes. Throws
  // Error(kInput) with the system's reason.
  explicit InputText(const std::string& path);

  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::optional<MappedFile> file_;
  std::string_view text_;
};

// How messages call it: the path, or "standard input".
[[nodiscard]] std::string input_name(const std::string& path);

}  // namespace quarry
