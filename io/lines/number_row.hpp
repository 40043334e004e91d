// A row of a table of numbers alone, between blanks, tabs, commas or semicolons.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quarry {

struct NumberRow {
  std::vector<double> numbers;
  std::string problem;  // "" if the row holds numbers and nothing else
};

// Reads a row. Empty cells, and cells of "NaN", may follow the last number, as tables have them that are as
// wide as their longest row; before it they are a problem.
void read_number_row(std::string_view row, NumberRow& result);

}  // namespace quarry
