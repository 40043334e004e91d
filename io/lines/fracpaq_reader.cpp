#include "io/lines/fracpaq_reader.hpp"

#include <utility>

#include <fmt/format.h>

#include "io/lines/number_row.hpp"
#include "io/text_rows.hpp"

namespace quarry {

void read_fracpaq_lines(const LineSource& source, LineSet& lines) {
  TextRows rows(source.text);
  NumberRow row;
  std::uint32_t feature = 0;
  while (rows.next()) {
    read_number_row(rows.row(), row);
    if (!row.problem.empty()) source.fail_at(rows.number(), row.problem);
    if (row.numbers.empty()) continue;
    if (row.numbers.size() % 2 != 0)
      source.fail_at(rows.number(),
                     fmt::format("{} numbers: a trace is pairs of x and y", row.numbers.size()));
    InputLine line;
    line.feature = feature++;
    for (std::size_t i = 0; i < row.numbers.size(); i += 2)
      line.points.push_back({row.numbers[i], row.numbers[i + 1]});
    append_line(source, rows.number(), std::move(line), lines);
  }
}

}  // namespace quarry
