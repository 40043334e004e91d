// Buckets over a box of the plane: which points lie in a box, which segments come near one. Ids are the
// positions in the array that the grid was built from, and always come out ascending, so that what is done
// with them does not depend on the cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/cell_tree.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

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
    tree_.visit_near(box, visit);
  }
  // All ids, cell by cell: an order in which neighbours lie near each other in memory.
  [[nodiscard]] std::span<const std::uint32_t> by_cells() const { return tree_.first_entries(); }

 private:
  std::span<const Vec2> points_;
  CellTree tree_;
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
    tree_.visit_near(box, visit);
  }

  // The same for the cells that a segment passes through.
  template <class Visit>
  void visit_along(const Segment& segment, Visit&& visit) const {
    tree_.visit_along(segment.from, segment.to, visit);
  }

  [[nodiscard]] std::size_t cell_count() const { return tree_.cell_count(); }
  // The segments entered in a cell, ascending. Two that have a common point share a cell that holds it.
  [[nodiscard]] std::span<const std::uint32_t> entries(std::size_t cell) const { return tree_.entries(cell); }
  // The positions of points, by the cells of this grid, then ascending: an order in which queries around one
  // after the other look at the same entries.
  [[nodiscard]] std::vector<std::uint32_t> by_cells(std::span<const Vec2> points) const;

 private:
  std::span<const Segment> segments_;
  CellTree tree_;
};

}  // namespace quarry
