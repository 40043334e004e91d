// First places for the vertices of a fill: the defect at the mean of the ends of its spokes, lines evenly
// divided, grids by transfinite interpolation of their borders; then all at harmonic places. What is folded
// after that is left to the smoothing that follows.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
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

// Whom each new vertex of a layout is joined to; kept from one fill to the next for its memory.
struct LayoutNeighbours {
  std::vector<std::uint32_t> begin;   // by vertex, of its row in joined
  std::vector<std::uint32_t> joined;  // rows of vertices
  std::vector<std::uint32_t> at;      // by vertex, where the next is put

  // The sides of the quads from each corner to the next: an inner edge is one of two quads, once each way.
  void build(const PatchLayout& layout) {
    const auto for_each_side = [&](const auto& visit) {
      for (const PatchLayout::Quad& quad : layout.quads())
        for (std::size_t k = 0; k < 4; ++k)
          if (quad[k] >= layout.rim()) visit(quad[k], quad[(k + 1) % 4]);
    };
    begin.assign(layout.vertices() + 1, 0);
    for_each_side([&](std::uint32_t v, std::uint32_t) { ++begin[v + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    joined.resize(begin.back());
    at.assign(begin.begin(), begin.end() - 1);
    for_each_side([&](std::uint32_t v, std::uint32_t w) { joined[at[v]++] = w; });
  }
};

// Moves the new vertices of a layout to the harmonic places: each in the middle of those that it is joined
// to, with the rim where it is, as in an embedding of Tutte (1963). Straight spokes fold the grids of patches
// that are not convex; this folds little, and lets smoothing begin near its end. By successive
// over-relaxation, a few sweeps for each row that a change has to cross. points: of all vertices of the
// layout; held: by vertex, those that stay; neighbours: scratch.
template <class Point>
void relax_layout(const PatchLayout& layout, const std::vector<bool>& held, std::vector<Point>& points,
                  LayoutNeighbours& neighbours) {
  constexpr double kSweepsPerRow = 3;
  neighbours.build(layout);
  const std::vector<std::uint32_t>& begin = neighbours.begin;
  const std::vector<std::uint32_t>& joined = neighbours.joined;
  const double rows = std::sqrt(static_cast<double>(layout.quads().size()));
  const double relaxation = 2 / (1 + std::sin(std::numbers::pi / std::max(rows, 2.0)));
  const int sweeps = static_cast<int>(kSweepsPerRow * rows);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::uint32_t v = layout.rim(); v < layout.vertices(); ++v) {
      if (held[v]) continue;
      Point sum{};
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) sum = sum + points[joined[i]];
      points[v] =
          (1 - relaxation) * points[v] + (relaxation / static_cast<double>(begin[v + 1] - begin[v])) * sum;
    }
  }
}

}  // namespace quarry
