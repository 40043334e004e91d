#include "io/lines/csv_rows.hpp"

#include <algorithm>

#include "io/text_rows.hpp"

namespace quarry {

void CsvRows::read_quoted(std::string& cell) {
  for (++at_; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '"') {
      const bool doubled = text_.substr(at_ + 1).starts_with('"');
      ++at_;
      if (!doubled) return;
    }
    if (c == '\n' || (c == '\r' && !text_.substr(at_ + 1).starts_with('\n'))) ++ended_;
    cell += c;
  }
  broken_ = true;
}

bool CsvRows::at_delimiter() const {
  return text_[at_] == delimiter_ || (delimiter_ == ' ' && is_blank(text_[at_]));
}

void CsvRows::read_cell() {
  while (at_ < text_.size() && is_blank(text_[at_]) && (delimiter_ == ' ' || text_[at_] != delimiter_)) ++at_;
  std::string cell;
  if (text_.substr(at_).starts_with('"')) read_quoted(cell);
  const std::size_t begin = at_;
  while (at_ < text_.size() && !at_delimiter() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  cell += text_.substr(begin, at_ - begin);
  cells_.emplace_back(trimmed(cell));
}

bool CsvRows::next() {
  if (at_ == text_.size()) return false;
  number_ = ended_ + 1;
  cells_.clear();
  for (;;) {
    read_cell();
    if (at_ == text_.size() || !at_delimiter()) break;
    ++at_;
  }
  if (at_ < text_.size()) {
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++ended_;
  }
  if (std::ranges::all_of(cells_, [](const std::string& cell) { return cell.empty(); })) cells_.clear();
  return true;
}

char find_delimiter(std::string_view first_row) {
  char best = 0;
  std::ptrdiff_t most = 0;
  for (const char delimiter : {',', ';', '\t', '|'}) {
    bool quoted = false;
    const std::ptrdiff_t count = std::ranges::count_if(first_row, [&](char c) {
      quoted = quoted != (c == '"');
      return !quoted && c == delimiter;
    });
    if (count > most) {
      most = count;
      best = delimiter;
    }
  }
  if (best == 0 && trimmed(first_row).find(' ') != std::string_view::npos) return ' ';
  return best;
}

}  // namespace quarry
