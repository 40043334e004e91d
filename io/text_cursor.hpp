// Reads words and numbers from the text of a file; an error names the file and the line.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/number_text.hpp"
#include "io/text_parts.hpp"

namespace quarry {

class TextCursor {
 public:
  // path is for messages only.
  TextCursor(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {}
  // Reads one part; errors still name the lines of the whole text.
  TextCursor(std::string path, std::string_view text, TextPart part)
      : path_(std::move(path)), text_(text.substr(0, part.end)), at_(part.begin) {}

  // Nothing but white space is left.
  [[nodiscard]] bool at_end() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    return at_ == text_.size();
  }
  // Nothing but blanks is left on this line.
  [[nodiscard]] bool at_line_end() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ == text_.size() || text_[at_] == '\n';
  }
  // The next word; an error if there is none.
  std::string_view word() {
    if (at_end()) fail("the file ends too early");
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  // The next word of this line; an error that names `what` is missing if there is none.
  std::string_view word_in_line(const char* what) {
    if (at_line_end()) fail_missing(what);
    return word();
  }
  // A word in double quotes.
  std::string_view quoted();
  // The rest of the line, without its end.
  std::string_view line() {
    const std::size_t begin = at_;
    // Most lines have been read to their end.
    std::size_t end = begin;
    if (begin == text_.size() || text_[begin] != '\n') end = std::min(text_.find('\n', begin), text_.size());
    at_ = std::min(end + 1, text_.size());
    return text_.substr(begin, end - begin);
  }

  // The next word as a number; an error that names `what` is expected.
  template <class Number>
  Number number(const char* what) {
    return parse<Number>(word(), what);
  }
  // The same for words that must stand on this line, and quicker. What follows `tail` in the word is passed
  // over: with '/' this reads the 7 of "7/1/2".
  template <class Number>
  Number number_in_line(const char* what, char tail = ' ') {
    if (at_line_end()) fail_missing(what);
    const char* const end = text_.data() + text_.size();
    const char* const at = text_.data() + at_;
    const char* const begin = at + (*at == '+' ? 1 : 0);
    Number value{};
    const auto [stop, failure] = read_number(begin, end, value);
    const bool whole = stop == end || is_space(*stop);
    if (failure != std::errc() || !(whole || *stop == tail)) fail_number(word(), what);
    at_ = static_cast<std::size_t>(stop - text_.data());
    if (!whole) word();
    return value;
  }
  // The next word of this line as a coordinate: a finite number.
  double coordinate() {
    const auto value = number_in_line<double>("a coordinate");
    if (!std::isfinite(value)) fail("a coordinate is not a finite number");
    return value;
  }
  template <class Number>
  Number parse(std::string_view digits, const char* what) {
    Number value{};
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
    const auto result = read_number(digits.data(), digits.data() + digits.size(), value);
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

  // Bytes before what is read next.
  [[nodiscard]] std::size_t position() const { return at_; }

  // Throws Error(kInput): "path:line: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  static constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static constexpr bool is_space(char c) { return is_blank(c) || c == '\n' || c == '\f' || c == '\v'; }

  [[noreturn]] void fail_number(std::string_view digits, const char* what) const;
  [[noreturn]] void fail_missing(const char* what) const;

  std::string path_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace quarry
