// Buckets over a box of the plane: which points lie in a box, which segments come near one. Ids are the
// positions in the array that the grid was built from, and always come out ascending, so that what is done
// with them does not depend on the cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

// Square cells over a box, row by row. Points outside belong to the nearest cell.
class CellFrame {
 public:
  // The side is enlarged where there would be more than cell_limit cells.
  CellFrame(const Box2& box, double side, std::size_t cell_limit);

  struct Range {
    std::uint32_t column_begin, column_end, row_begin, row_end;
  };

  [[nodiscard]] double side() const { return side_; }
  [[nodiscard]] std::size_t size() const { return std::size_t{columns_} * rows_; }
  [[nodiscard]] std::uint32_t column(double x) const { return number(x - low_.x, columns_); }
  [[nodiscard]] std::uint32_t row(double y) const { return number(y - low_.y, rows_); }
  [[nodiscard]] std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * columns_ + column;
  }
  // The cells that hold a point of the box, which is not empty.
  [[nodiscard]] Range range(const Box2& box) const {
    return {column(box.low.x), column(box.high.x) + 1, row(box.low.y), row(box.high.y) + 1};
  }
  // Calls visit(id) for the ids of the cells that hold a point of the box; begin: where the ids of each cell
  // begin, and the end of the last. Nothing for an empty box.
  template <class Visit>
  void for_each_entry(const Box2& box, std::span<const std::uint32_t> begin,
                      std::span<const std::uint32_t> ids, Visit&& visit) const {
    if (box.empty()) return;
    const Range cells = range(box);
    for (std::uint32_t row = cells.row_begin; row < cells.row_end; ++row) {
      // The cells of a row follow each other.
      const std::uint32_t first = begin[index(cells.column_begin, row)];
      const std::uint32_t last = begin[index(cells.column_end - 1, row) + 1];
      for (std::uint32_t i = first; i < last; ++i) visit(ids[i]);
    }
  }
  // Calls visit(cell) for a superset of the cells that hold a point of the segment.
  template <class Visit>
  void for_each_cell_of_segment(Vec2 a, Vec2 b, Visit&& visit) const {
    const auto [row_begin, row_end] = rows_of_segment(a, b);
    for (std::uint32_t row = row_begin; row < row_end; ++row) {
      const auto [begin, end] = columns_of_segment(a, b, row);
      for (std::uint32_t column = begin; column < end; ++column) visit(index(column, row));
    }
  }

 private:
  struct Interval {
    std::uint32_t begin, end;
  };
  [[nodiscard]] std::uint32_t number(double offset, std::uint32_t count) const;
  [[nodiscard]] Interval rows_of_segment(Vec2 a, Vec2 b) const;
  [[nodiscard]] Interval columns_of_segment(Vec2 a, Vec2 b, std::uint32_t row) const;

  Vec2 low_;
  double side_;
  double slack_;  // more than what rounding can move a coordinate by
  std::uint32_t columns_;
  std::uint32_t rows_;
};

// Finds points. Keeps a view of them: they must outlive the grid and stay where they are.
class PointGrid {
 public:
  // side: of the cells, best near the usual size of a query (units of the points); > 0.
  PointGrid(std::span<const Vec2> points, double side);

  // Replaces ids by those of the points in the closed box, ascending.
  void find(const Box2& box, std::vector<std::uint32_t>& ids) const;

  // Calls visit(id) for the points of the cells that hold a point of the box, in no order.
  template <class Visit>
  void visit_near(const Box2& box, Visit&& visit) const {
    frame_.for_each_entry(box, begin_, ids_, visit);
  }
  // All ids, cell by cell: an order in which neighbours lie near each other in memory.
  [[nodiscard]] std::span<const std::uint32_t> by_cells() const { return ids_; }

 private:
  std::span<const Vec2> points_;
  CellFrame frame_;
  std::vector<std::uint32_t> begin_;  // of each cell in ids_, and the end of the last
  std::vector<std::uint32_t> ids_;
};

struct Segment {
  Vec2 from;
  Vec2 to;
};

// Finds segments. Keeps a view of them: they must outlive the grid and stay where they are.
class SegmentGrid {
 public:
  // side: of the cells, best near the usual size of a query (units of the points); > 0. A segment is entered
  // in each cell that it passes through, so the side is enlarged to an eighth of the mean length if it is
  // less.
  SegmentGrid(std::span<const Segment> segments, double side);

  // Replaces ids by those of the segments near the closed box, each once, ascending: all that meet it, and
  // some that do not but whose own boxes do.
  void find(const Box2& box, std::vector<std::uint32_t>& ids) const;

  // Calls visit(id) for the segments entered in the cells that hold a point of the box: all that meet it, and
  // others; in no order, and each once for each of those cells that it is entered in.
  template <class Visit>
  void visit_near(const Box2& box, Visit&& visit) const {
    frame_.for_each_entry(box, begin_, ids_, visit);
  }

  // The same for the cells that a segment passes through.
  template <class Visit>
  void visit_along(const Segment& segment, Visit&& visit) const {
    frame_.for_each_cell_of_segment(segment.from, segment.to, [&](std::size_t cell) {
      for (const std::uint32_t id : entries(cell)) visit(id);
    });
  }

  [[nodiscard]] std::size_t cell_count() const { return frame_.size(); }
  // The segments entered in a cell, ascending. Two that have a common point share a cell that holds it.
  [[nodiscard]] std::span<const std::uint32_t> entries(std::size_t cell) const {
    return std::span(ids_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
  }
  // The positions of points, by the cells of this grid, then ascending: an order in which queries around one
  // after the other look at the same entries.
  [[nodiscard]] std::vector<std::uint32_t> by_cells(std::span<const Vec2> points) const;

 private:
  std::span<const Segment> segments_;
  CellFrame frame_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace quarry
