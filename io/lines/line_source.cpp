#include "io/lines/line_source.hpp"

#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

void LineSource::fail_at(std::size_t row, const std::string& message) const {
  throw Error(ErrorKind::kInput, fmt::format("{}:{}: {}", name, row, message));
}

void append_line(const LineSource& source, std::size_t row, InputLine line, LineSet& lines) {
  if (line.points.size() == 1)
    source.fail_at(row, fmt::format("a line of one point at {}; a line needs two points",
                                    format_point(line.points[0].x, line.points[0].y)));
  line.file = source.file;
  if (line.heights.size() != line.points.size()) line.heights.clear();
  lines.lines.push_back(std::move(line));
}

}  // namespace quarry
