#include "engine/geometry/cell_tree.hpp"

#include <cassert>
#include <utility>

namespace quarry {

CellTree::CellTree(const CellFrame& frame, CellEntries entries)
    : parts_{{frame, 0}}, entries_(std::move(entries)) {
  assert(entries_.begin.size() == frame.size() + 1);
}

void CellTree::split(std::size_t cell, const CellFrame& frame, const CellEntries& entries) {
  assert(entries.begin.size() == frame.size() + 1 && !is_split(cell));
  part_of_.resize(cell_count() + frame.size(), kWhole);
  part_of_[cell] = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({frame, cell_count()});
  const std::uint32_t offset = entries_.begin.back();
  entries_.begin.pop_back();
  for (const std::uint32_t begin : entries.begin) entries_.begin.push_back(offset + begin);
  entries_.ids.insert(entries_.ids.end(), entries.ids.begin(), entries.ids.end());
}

std::size_t CellTree::cell_of(Vec2 p) const {
  std::size_t cell = parts_[0].frame.index(p);
  while (is_split(cell)) {
    const Part& part = parts_[part_of_[cell]];
    cell = part.first_cell + part.frame.index(p);
  }
  return cell;
}

}  // namespace quarry
