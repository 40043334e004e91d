#include "io/text_cursor.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
constexpr bool is_space(char c) { return is_blank(c) || c == '\n' || c == '\f' || c == '\v'; }

}  // namespace

bool TextCursor::at_end() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  return at_ == text_.size();
}

bool TextCursor::at_line_end() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  return at_ == text_.size() || text_[at_] == '\n';
}

std::string_view TextCursor::word() {
  if (at_end()) fail("the file ends too early");
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextCursor::quoted() {
  if (at_end() || text_[at_] != '"') fail("a name in double quotes is expected");
  const std::size_t end = text_.find('"', at_ + 1);
  if (end == std::string_view::npos) fail("a name in double quotes does not end");
  const std::string_view name = text_.substr(at_ + 1, end - at_ - 1);
  at_ = end + 1;
  return name;
}

std::string_view TextCursor::line() {
  const std::size_t begin = at_;
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  at_ = std::min(end + 1, text_.size());
  return text_.substr(begin, end - begin);
}

void TextCursor::fail(const std::string& message) const {
  // A line that was taken whole is the one to name, not the one after its end.
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at_ == 0 ? 0 : at_ - 1);
  throw Error(ErrorKind::kInput,
              fmt::format("{}:{}: {}", path_, 1 + std::count(text_.begin(), end, '\n'), message));
}

void TextCursor::fail_number(std::string_view digits, const char* what) const {
  fail(fmt::format("{} is expected, not \"{}\"", what, digits.substr(0, 40)));
}

}  // namespace quarry
