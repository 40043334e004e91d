// Square cells over a box of the plane: which of them hold a point, which a box or a segment comes into.
#pragma once

#include <cstddef>
#include <cstdint>

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
  // More than what rounding can move a coordinate by.
  [[nodiscard]] double slack() const { return slack_; }
  [[nodiscard]] std::size_t size() const { return std::size_t{columns_} * rows_; }
  [[nodiscard]] std::uint32_t column(double x) const { return number(x - low_.x, columns_); }
  [[nodiscard]] std::uint32_t row(double y) const { return number(y - low_.y, rows_); }
  [[nodiscard]] std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * columns_ + column;
  }
  [[nodiscard]] std::size_t index(Vec2 p) const { return index(column(p.x), row(p.y)); }
  // The cells that hold a point of the box, which is not empty.
  [[nodiscard]] Range range(const Box2& box) const {
    return {column(box.low.x), column(box.high.x) + 1, row(box.low.y), row(box.high.y) + 1};
  }
  // What a cell covers, and a little more.
  [[nodiscard]] Box2 box(std::size_t cell) const;
  // Cells over a part of this box, for the same segments: what rounding does is reckoned for all of it.
  [[nodiscard]] CellFrame within(const Box2& part, double side, std::size_t cell_limit) const;

  // Calls visit(cell) for a superset of the cells that hold a point of the segment. Parts of it outside the
  // box belong to no cell.
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
  double slack_;
  std::uint32_t columns_;
  std::uint32_t rows_;
};

}  // namespace quarry
