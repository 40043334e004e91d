// The lines of a text that hold something: neither blank nor a comment. Formats that announce how many lines
// of what follow are read by the number of the line, in parallel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_cursor.hpp"

namespace quarry {

class ContentLines {
 public:
  // The lines of the text from the byte `begin` on, which starts a line. A line whose first character is
  // `comment` is one ('\0': there are none).
  ContentLines(std::string path, std::string_view text, std::size_t begin, char comment);

  [[nodiscard]] std::size_t count() const { return first_.back(); }

  // Calls read(cursor, i) for the lines first + i, i of [0, count), in any order and at the same time; the
  // cursor stands at the first word of the line, and what read leaves of the line is passed over.
  template <class Read>
  void read(std::size_t first, std::size_t count, Read&& read) const {
    const std::size_t last = first + count;
    const auto begin =
        static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), first) - first_.begin() - 1);
    const auto end =
        static_cast<std::size_t>(std::lower_bound(first_.begin(), first_.end(), last) - first_.begin());
    if (count == 0) return;
    read_parts(end - begin, [&](std::size_t k) {
      TextCursor cursor(path_, text_, parts_[begin + k]);
      for (std::size_t i = first_[begin + k]; i < std::min(last, first_[begin + k + 1]); ++i) {
        find_content(cursor);
        if (i >= first) read(cursor, i - first);
        cursor.line();
      }
    });
  }

  // Throws Error(kInput) that names the given line, or the end of the file: "path:line: message".
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

 private:
  // Moves to the first word of the next line with content; false if there is none.
  bool find_content(TextCursor& cursor) const {
    while (!cursor.at_end()) {
      if (comment_ == '\0' || text_[cursor.position()] != comment_) return true;
      cursor.line();
    }
    return false;
  }

  std::string path_;
  std::string_view text_;
  char comment_;
  std::vector<TextPart> parts_;
  std::vector<std::size_t> first_;  // number of the first line of each part; then the number of all lines
};

}  // namespace quarry
