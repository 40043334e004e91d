#include "io/mesh/content_lines.hpp"

#include <span>

namespace quarry {

ContentLines::ContentLines(std::string path, std::string_view text, std::size_t begin, char comment)
    : path_(std::move(path)), text_(text), comment_(comment), parts_(split_lines(text, begin)) {
  first_.assign(parts_.size() + 1, 0);
  read_parts(parts_.size(), [&](std::size_t k) {
    TextCursor cursor(path_, text_, parts_[k]);
    for (; find_content(cursor); cursor.line()) ++first_[k];
  });
  parallel::exclusive_scan(std::span(first_));
}

void ContentLines::fail_at(std::size_t line, const std::string& message) const {
  if (line < count())
    read(line, 1, [&](TextCursor& cursor, std::size_t) {
      cursor.word();
      cursor.fail(message);
    });
  TextCursor cursor(path_, text_, {text_.size(), text_.size()});
  cursor.fail(message);
}

}  // namespace quarry
