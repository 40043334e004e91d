#include "engine/geometry/raster.hpp"

#include <algorithm>
#include <cmath>

namespace quarry {
namespace {

// The two cells along one axis that a value is taken from, and the share of the second.
struct Between {
  std::size_t first, second;
  double share;
};

Between between(double place, std::size_t cells) {
  const double last = static_cast<double>(cells - 1);
  const double from = std::clamp(place - 0.5, 0.0, last);
  const double whole = std::floor(from);
  const auto first = static_cast<std::size_t>(whole);
  return {first, std::min(first + 1, cells - 1), from - whole};
}

}  // namespace

std::optional<double> Raster::at(Vec2 p) const {
  // In cells, from the left and from the top.
  const double x = (p.x - low.x) / cell;
  const double y = static_cast<double>(rows) - (p.y - low.y) / cell;
  if (!(x >= 0 && x <= static_cast<double>(columns) && y >= 0 && y <= static_cast<double>(rows)))
    return std::nullopt;
  const auto value = [&](std::size_t row, std::size_t column) { return values[row * columns + column]; };
  if (std::isnan(value(std::min(static_cast<std::size_t>(y), rows - 1),
                       std::min(static_cast<std::size_t>(x), columns - 1))))
    return std::nullopt;
  const Between across = between(x, columns);
  const Between down = between(y, rows);
  double sum = 0;
  double weights = 0;
  const auto add = [&](std::size_t row, std::size_t column, double weight) {
    const double v = value(row, column);
    if (std::isnan(v)) return;
    sum += weight * v;
    weights += weight;
  };
  add(down.first, across.first, (1 - down.share) * (1 - across.share));
  add(down.first, across.second, (1 - down.share) * across.share);
  add(down.second, across.first, down.share * (1 - across.share));
  add(down.second, across.second, down.share * across.share);
  // The cell that holds the place has data, and at least a quarter of the weight.
  return sum / weights;
}

}  // namespace quarry
