// First places for the vertices of a fill: the defect at the mean of the ends of its spokes, lines evenly
// divided, grids by transfinite interpolation of their borders. Folds are left to the smoothing that follows.
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "kernels/cleanup/patch_layout.hpp"

namespace quarry {

namespace detail {

template <class Point>
void place_line(std::span<const std::uint32_t> line, std::vector<Point>& points) {
  const Point from = points[line.front()];
  const Point along = points[line.back()] - from;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    points[line[i]] = from + (static_cast<double>(i) / static_cast<double>(line.size() - 1)) * along;
}

// x(u, v) = (1 - v) S + v N + (1 - u) W + u E - the bilinear map of the corners (Gordon & Hall 1973).
template <class Point>
void place_grid(std::span<const std::uint32_t> ids, std::uint32_t columns, std::uint32_t rows,
                std::vector<Point>& points) {
  const auto at = [&](std::uint32_t column, std::uint32_t row) -> Point& {
    return points[ids[std::size_t{row} * (columns + 1) + column]];
  };
  for (std::uint32_t row = 1; row < rows; ++row) {
    const double v = static_cast<double>(row) / rows;
    for (std::uint32_t column = 1; column < columns; ++column) {
      const double u = static_cast<double>(column) / columns;
      const Point south = (1 - u) * at(0, 0) + u * at(columns, 0);
      const Point north = (1 - u) * at(0, rows) + u * at(columns, rows);
      at(column, row) = (1 - v) * (at(column, 0) - south) + v * (at(column, rows) - north) +
                        (1 - u) * at(0, row) + u * at(columns, row);
    }
  }
}

}  // namespace detail

// points: those of the rim on entry, those of all vertices of the layout afterwards.
template <class Point>
void place_layout(const PatchLayout& layout, std::vector<Point>& points) {
  assert(points.size() == layout.rim());
  points.resize(layout.vertices());
  const PatchLayout::Centre& centre = layout.centre();
  const auto lines = layout.lines();
  for (std::size_t i = 0; i < centre.lines_before; ++i) detail::place_line(layout.members(lines[i]), points);
  if (centre.count > 0) {
    Point sum{};
    for (std::uint32_t i = 0; i < centre.count; ++i) sum = sum + points[centre.ends[i]];
    points[centre.vertex] = (1.0 / centre.count) * sum;
  }
  for (std::size_t i = centre.lines_before; i < lines.size(); ++i)
    detail::place_line(layout.members(lines[i]), points);
  for (const PatchLayout::Grid& grid : layout.grids())
    detail::place_grid(layout.members(grid), grid.columns, grid.rows, points);
}

}  // namespace quarry
