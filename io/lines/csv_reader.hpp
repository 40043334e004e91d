// Tables of lines: a point a row, or a geometry in well-known text a row.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the lines of a table whose first row names its columns, as io/lines/csv_columns.hpp tells: either
// one with well-known text, or x and y (and z). Rows of points follow one another along their line; a line
// ends where the column of line numbers changes, and at a blank row. A number that comes again after another
// line is an error. Without names, rows of two or three numbers are x, y and z, and lines end at blank rows
// alone. Where semicolons part the cells, commas are decimal points. Errors name the row, and are as in
// read_lines.
void read_csv_lines(const LineSource& source, LineSet& lines);

// The same for a table with names whose delimiter is known.
void read_csv_table(const LineSource& source, char delimiter, LineSet& lines);

}  // namespace quarry
