// The rows of a text with any of the three line ends: "\n", "\r\n" and "\r" alone, which old tables have.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace quarry {

class TextRows {
 public:
  explicit TextRows(std::string_view text) : text_(text) {}

  // Moves to the next row; false if there is none.
  bool next() {
    if (at_ == text_.size()) return false;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    row_ = text_.substr(at_, end - at_);
    at_ = std::min(end + (text_.substr(end).starts_with("\r\n") ? 2 : 1), text_.size());
    ++number_;
    return true;
  }

  // Without its end.
  [[nodiscard]] std::string_view row() const { return row_; }
  // From 1.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view text_;
  std::string_view row_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

[[nodiscard]] constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace quarry
