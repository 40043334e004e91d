// Entries of things in the cells of a frame, where cells with many entries are split by frames of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/cell_frame.hpp"

namespace quarry {

// The ids entered in some cells, one cell after the other.
struct CellEntries {
  std::vector<std::uint32_t> begin;  // of each cell in ids, and the end of the last
  std::vector<std::uint32_t> ids;
};

// Cells are numbered through: those of the first frame, then those of each that was added. A split cell keeps
// its number, but all that lies in it is found in the cells of its frame.
class CellTree {
 public:
  CellTree(const CellFrame& frame, CellEntries entries);

  // Splits a cell that is not split yet. frame: over that cell, or the part of it in which all its ids are;
  // entries: of the same ids in its cells.
  void split(std::size_t cell, const CellFrame& frame, const CellEntries& entries);

  struct Part {
    CellFrame frame;
    std::size_t first_cell;
  };
  // The first frame, and those added since.
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  // Split cells and empty ones included.
  [[nodiscard]] std::size_t cell_count() const { return entries_.begin.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> entries(std::size_t cell) const {
    if (is_split(cell)) return {};
    return std::span(entries_.ids)
        .subspan(entries_.begin[cell], entries_.begin[cell + 1] - entries_.begin[cell]);
  }
  // The ids as they were entered in the first frame.
  [[nodiscard]] std::span<const std::uint32_t> first_entries() const {
    return std::span(entries_.ids).first(entries_.begin[parts_[0].frame.size()]);
  }
  // The one that holds a point; it is not split.
  [[nodiscard]] std::size_t cell_of(Vec2 p) const;

  // Calls visit(id) for the ids of the cells that hold a point of the box, and a few near by. Nothing for an
  // empty box.
  template <class Visit>
  void visit_near(const Box2& box, Visit&& visit) const {
    if (!box.empty()) visit_part_near(parts_[0], box, visit);
  }
  // The same for the cells that hold a point of a segment.
  template <class Visit>
  void visit_along(Vec2 a, Vec2 b, Visit&& visit) const {
    visit_part_along(parts_[0], a, b, visit);
  }

 private:
  static constexpr std::uint32_t kWhole = 0;  // the first frame splits no cell

  [[nodiscard]] bool is_split(std::size_t cell) const {
    return !part_of_.empty() && part_of_[cell] != kWhole;
  }
  template <class Visit>
  void visit_part_near(const Part& part, const Box2& box, Visit& visit) const;
  template <class Visit>
  void visit_part_along(const Part& part, Vec2 a, Vec2 b, Visit& visit) const;

  std::vector<Part> parts_;
  CellEntries entries_;                 // of all cells
  std::vector<std::uint32_t> part_of_;  // that splits a cell, or kWhole; empty while none is split
};

template <class Visit>
void CellTree::visit_part_near(const Part& part, const Box2& box, Visit& visit) const {
  const CellFrame::Range cells = part.frame.range(box);
  for (std::uint32_t row = cells.row_begin; row < cells.row_end; ++row) {
    // The cells of a row follow each other.
    const std::size_t first = part.first_cell + part.frame.index(cells.column_begin, row);
    const std::size_t end = part.first_cell + part.frame.index(cells.column_end - 1, row) + 1;
    if (part_of_.empty()) {
      for (std::uint32_t i = entries_.begin[first]; i < entries_.begin[end]; ++i) visit(entries_.ids[i]);
      continue;
    }
    for (std::size_t cell = first; cell < end; ++cell) {
      if (is_split(cell)) {
        visit_part_near(parts_[part_of_[cell]], box, visit);
      } else {
        for (std::uint32_t i = entries_.begin[cell]; i < entries_.begin[cell + 1]; ++i)
          visit(entries_.ids[i]);
      }
    }
  }
}

template <class Visit>
void CellTree::visit_part_along(const Part& part, Vec2 a, Vec2 b, Visit& visit) const {
  part.frame.for_each_cell_of_segment(a, b, [&](std::size_t index) {
    const std::size_t cell = part.first_cell + index;
    if (is_split(cell)) {
      visit_part_along(parts_[part_of_[cell]], a, b, visit);
    } else {
      for (const std::uint32_t id : entries(cell)) visit(id);
    }
  });
}

}  // namespace quarry
