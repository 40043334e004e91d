#include "io/lines/number_row.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/coordinate_limit.hpp"
#include "io/number_text.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

constexpr bool is_separator(char c) { return c == '\t' || c == ',' || c == ';'; }

}  // namespace

void read_number_row(std::string_view row, NumberRow& result) {
  result.numbers.clear();
  result.problem.clear();
  if (row.find(',') != std::string_view::npos && row.find(';') != std::string_view::npos) {
    result.problem = "commas and semicolons, without names of columns: is 1,5 one number or two?";
    return;
  }
  bool gap = false;      // cells without a number since the last one
  bool in_cell = false;  // since the last separator there was a number
  const char* const end = row.data() + row.size();
  for (const char* at = row.data(); at != end;) {
    if (is_separator(*at)) {
      gap = gap || !in_cell;
      in_cell = false;
      ++at;
      continue;
    }
    if (is_blank(*at)) {
      ++at;
      continue;
    }
    const char* const stop = std::find_if(at, end, [](char c) { return is_separator(c) || is_blank(c); });
    const char* const begin = at + (*at == '+' ? 1 : 0);
    double value = 0;
    const auto [read, failure] = read_number(begin, stop, value);
    const std::string_view text(at, static_cast<std::size_t>(stop - at));
    at = stop;
    if (read != stop || failure == std::errc::invalid_argument) {
      result.problem = fmt::format("a number is expected, not \"{}\"", text.substr(0, 40));
      return;
    }
    if (std::isnan(value)) {
      gap = true;
      in_cell = true;
      continue;
    }
    if (failure != std::errc() || !is_usable_coordinate(value)) {
      result.problem = fmt::format("coordinate {} is not a usable number; the largest is {:g}",
                                   text.substr(0, 40), kLargestCoordinate);
      return;
    }
    if (gap) {
      result.problem = fmt::format("a number is missing before {}", text.substr(0, 40));
      return;
    }
    in_cell = true;
    result.numbers.push_back(value);
  }
}

}  // namespace quarry
