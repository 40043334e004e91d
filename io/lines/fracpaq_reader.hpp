// Traces as FracPaQ writes them (Healy et al. 2017): a row for each, x y x y ..., between tabs, blanks or
// commas.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends a line for each row that is not blank. Rows may be padded with empty or NaN cells. Errors name the
// row, and are as in read_lines.
void read_fracpaq_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
