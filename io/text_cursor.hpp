// Reads words and numbers from the text of a file; an error names the file and the line.
#pragma once

#include <charconv>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace quarry {

class TextCursor {
 public:
  // path is for messages only.
  TextCursor(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {}

  // Nothing but white space is left.
  [[nodiscard]] bool at_end();
  // Nothing but blanks is left on this line.
  [[nodiscard]] bool at_line_end();
  // The next word; an error if there is none.
  std::string_view word();
  // A word in double quotes.
  std::string_view quoted();
  // The rest of the line, without its end.
  std::string_view line();

  // The next word as a number; an error that names `what` is expected.
  template <class Number>
  Number number(const char* what) {
    return parse<Number>(word(), what);
  }
  template <class Number>
  Number parse(std::string_view digits, const char* what) {
    Number value{};
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size()) fail_number(digits, what);
    return value;
  }

  // The next bytes as a value of this machine's layout, for the binary parts of a file; an error at its end.
  template <class Value>
  Value raw() {
    static_assert(std::is_arithmetic_v<Value>);
    if (text_.size() - at_ < sizeof(Value)) fail("the file ends too early");
    Value value;
    std::memcpy(&value, text_.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
    return value;
  }

  // Throws Error(kInput): "path:line: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  [[noreturn]] void fail_number(std::string_view digits, const char* what) const;

  std::string path_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace quarry
