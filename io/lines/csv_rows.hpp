// Rows of a table with cells between commas, semicolons, tabs or bars (RFC 4180, and what spreadsheets make
// of it): cells in quotes may hold all of those, and line ends.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

class CsvRows {
 public:
  CsvRows(std::string_view text, char delimiter) : text_(text), delimiter_(delimiter) {}

  // Moves to the next row; false at the end of the text.
  bool next();

  // Without blanks and quotes around them; a blank row has none.
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }
  // In which the row begins, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  // A quote does not end: the row is the rest of the text.
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  [[nodiscard]] bool at_delimiter() const;
  void read_cell();
  void read_quoted(std::string& cell);

  std::string_view text_;
  char delimiter_;
  std::vector<std::string> cells_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::size_t ended_ = 0;  // line ends before at_
  bool broken_ = false;
};

// The delimiter that the first row has most of, outside of quotes; ' ' for any number of blanks if it has
// none of the others, and 0 if it has none at all.
[[nodiscard]] char find_delimiter(std::string_view first_row);

}  // namespace quarry
