#include "io/lines/csv_reader.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/coordinate_limit.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/csv_columns.hpp"
#include "io/lines/csv_rows.hpp"
#include "io/lines/line_attributes.hpp"
#include "io/lines/number_row.hpp"
#include "io/lines/wkt_geometry.hpp"
#include "io/number_text.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

constexpr std::size_t kNone = CsvColumns::kNone;

// The first row that is neither blank nor a comment; "" if there is none.
std::string_view find_first_row(std::string_view text) {
  TextRows rows(text);
  while (rows.next())
    if (const std::string_view row = trimmed(rows.row()); !row.empty() && row.front() != '#') return row;
  return {};
}

class CsvReader {
 public:
  CsvReader(const LineSource& source, LineSet& lines, char delimiter)
      : source_(source), lines_(lines), delimiter_(delimiter), rows_(source.text, delimiter) {}

  void read() {
    read_header();
    while (next()) columns_.wkt == kNone ? read_point() : read_geometry();
    end_line();
    lines_.systems[source_.file] = describe_system(columns_.degrees ? "OGC:CRS84" : system_);
    attributes_.tell(source_.name);
  }

 private:
  bool next() {
    if (!rows_.next()) return false;
    if (rows_.broken()) source_.fail_at(rows_.number(), "a quote does not end");
    return true;
  }

  void read_header() {
    do {
      if (!next()) return;
    } while (rows_.cells().empty() || rows_.cells().front().starts_with('#'));
    columns_ = find_csv_columns(rows_.cells());
    if (!columns_.holds_lines())
      source_.fail_at(
          rows_.number(),
          "no column is called x and y, or wkt: name the columns in the first row, such as x,y,line");
  }

  [[nodiscard]] std::string_view cell(std::size_t column) const {
    return column < rows_.cells().size() ? std::string_view(rows_.cells()[column]) : std::string_view();
  }

  double number(std::size_t column, const char* what) const {
    std::string text(cell(column));
    if (text.empty()) source_.fail_at(rows_.number(), fmt::format("{} is missing", what));
    if (delimiter_ == ';') std::replace(text.begin(), text.end(), ',', '.');
    const char* const begin = text.data() + (text.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [stop, failure] = read_number(begin, text.data() + text.size(), value);
    if (failure == std::errc::invalid_argument || stop != text.data() + text.size())
      source_.fail_at(rows_.number(), fmt::format("{} is expected, not \"{}\"", what, text.substr(0, 40)));
    if (failure != std::errc() || !is_usable_coordinate(value))
      source_.fail_at(rows_.number(), fmt::format("coordinate {} is not a usable number; the largest is {:g}",
                                                  text.substr(0, 40), kLargestCoordinate));
    return value;
  }

  void take_attributes() {
    for (const auto& [column, name] : columns_.attributes) attributes_.set(name, cell(column));
  }

  void read_geometry() {
    if (rows_.cells().empty()) return;
    const std::uint32_t feature = feature_++;
    const std::string_view text = cell(columns_.wkt);
    if (text.empty()) return;
    const LineSetMark first = LineSetMark::of(lines_);
    WktGeometry geometry = read_wkt_geometry(text, source_.file, feature, lines_);
    if (geometry.problem.empty() && geometry.end < text.size())
      geometry.problem =
          fmt::format("\"{}\" after a geometry", trimmed(text.substr(geometry.end)).substr(0, 40));
    if (!geometry.problem.empty())
      source_.fail_at(rows_.number(), geometry.problem + (text.find(')') == std::string_view::npos
                                                              ? "; with commas it has to stand in quotes"
                                                              : ""));
    if (!geometry.system.empty()) system_ = geometry.system;
    take_attributes();
    attributes_.assign(first, lines_);
  }

  void read_point() {
    if (rows_.cells().empty()) {
      if (columns_.line == kNone) end_line();
      return;
    }
    if (cell(0).starts_with('#')) return;
    if (columns_.point != kNone) return append_point();
    const std::string_view name = cell(columns_.line);
    if (!line_.points.empty() && name != name_) end_line();
    if (line_.points.empty()) begin_line(name);
    line_.points.push_back({number(columns_.x, "x"), number(columns_.y, "y")});
    if (!cell(columns_.z).empty()) line_.heights.push_back(number(columns_.z, "z"));
  }

  // Its name is that of the column, unless there is one called so.
  void append_point() {
    const LineSetMark first = LineSetMark::of(lines_);
    InputPoint point{{number(columns_.x, "x"), number(columns_.y, "y")}};
    if (!cell(columns_.z).empty()) point.height = number(columns_.z, "z");
    point.file = source_.file;
    point.feature = feature_++;
    lines_.points.push_back(point);
    attributes_.set("name", cell(columns_.point));
    take_attributes();
    attributes_.assign(first, lines_);
  }

  void begin_line(std::string_view name) {
    name_ = name;
    row_ = rows_.number();
    line_.feature = feature_++;
    take_attributes();
    if (columns_.line != kNone && !seen_.insert(name_).second)
      source_.fail_at(row_, fmt::format("line {} comes again after another one: sort the rows by it", name_));
  }

  void end_line() {
    if (line_.points.empty()) return;
    const LineSetMark first = LineSetMark::of(lines_);
    append_line(source_, row_, std::exchange(line_, {}), lines_);
    attributes_.assign(first, lines_);
  }

  const LineSource& source_;
  LineSet& lines_;
  char delimiter_;
  CsvRows rows_;
  CsvColumns columns_;
  AttributeCollector attributes_;
  std::string system_;
  std::uint32_t feature_ = 0;
  // The line whose points are collected.
  InputLine line_;
  std::string name_;
  std::size_t row_ = 0;
  std::set<std::string, std::less<>> seen_;
};

// Rows of two or three numbers.
void read_bare_points(const LineSource& source, LineSet& lines) {
  TextRows rows(source.text);
  NumberRow row;
  InputLine line;
  std::uint32_t feature = 0;
  std::size_t begin = 1;
  const auto end_line = [&] {
    if (line.points.empty()) return;
    line.feature = feature++;
    append_line(source, begin, std::exchange(line, {}), lines);
  };
  while (rows.next()) {
    if (trimmed(rows.row()).starts_with('#')) continue;
    read_number_row(rows.row(), row);
    if (!row.problem.empty()) source.fail_at(rows.number(), row.problem);
    if (row.numbers.empty()) {
      end_line();
      continue;
    }
    if (row.numbers.size() != 2 && row.numbers.size() != 3)
      source.fail_at(rows.number(), fmt::format("{} numbers: a point is x and y, or x, y and z; name other "
                                                "columns in the first row",
                                                row.numbers.size()));
    if (line.points.empty()) begin = rows.number();
    line.points.push_back({row.numbers[0], row.numbers[1]});
    if (row.numbers.size() == 3) line.heights.push_back(row.numbers[2]);
  }
  end_line();
}

}  // namespace

void read_csv_lines(const LineSource& source, LineSet& lines) {
  const std::string_view first = find_first_row(source.text);
  NumberRow numbers;
  read_number_row(first, numbers);
  if (numbers.problem.empty()) return read_bare_points(source, lines);
  const char delimiter = find_delimiter(first);
  read_csv_table(source, delimiter != 0 ? delimiter : ',', lines);
}

void read_csv_table(const LineSource& source, char delimiter, LineSet& lines) {
  CsvReader(source, lines, delimiter).read();
}

}  // namespace quarry
