// Values on a grid of square cells, as geographic systems write them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct Raster {
  std::size_t columns = 0, rows = 0;
  Vec2 low;                    // the lower left corner of the lower left cell
  double cell = 1;             // side of a cell
  std::vector<double> values;  // row by row from the top; NaN in cells without data

  // The value at a place: bilinear between the centres of the cells, and in the outer half of the outermost
  // ones as on the way from centre to centre along the rim. Cells without data do not count beside others;
  // none outside of the grid and in cells without data.
  [[nodiscard]] std::optional<double> at(Vec2 p) const;
};

}  // namespace quarry
