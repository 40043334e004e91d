#include "io/text_cursor.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

std::string_view TextCursor::quoted() {
  if (at_end() || text_[at_] != '"') fail("a name in double quotes is expected");
  const std::size_t end = text_.find('"', at_ + 1);
  if (end == std::string_view::npos) fail("a name in double quotes does not end");
  const std::string_view name = text_.substr(at_ + 1, end - at_ - 1);
  at_ = end + 1;
  return name;
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

void TextCursor::fail_missing(const char* what) const { fail(fmt::format("{} is missing", what)); }

}  // namespace quarry
