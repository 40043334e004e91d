// Things entered in the cells of a tree that is split as long as that spreads them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/cell_tree.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {

// Items: what is entered. size(): how many; for_each_cell(frame, id, visit): the cells of one; extend(box,
// id, within): makes a box hold the part of one that lies in another box, and returns the length of that
// part.
template <class Items>
class CellTreeBuilder {
 public:
  // side: of the cells if they are to hold few entries each; where items crowd, cells are made that small.
  CellTreeBuilder(const Items& items, double side) : items_(items), side_(side) {}

  // box: of all items; first_side: of the cells that are not split, enlarged to what the number of items
  // allows.
  CellTree build(const Box2& box, double first_side) const {
    const CellFrame frame(box, first_side, most_cells(items_.size()));
    CellTree tree(frame, enter_all(frame));
    for (std::size_t first = 0; first < tree.parts().size();) {
      const std::size_t end = tree.parts().size();
      for (; first < end; ++first) split_crowded(tree, first);
    }
    return tree;
  }

 private:
  // More cells than items only cost memory.
  static std::size_t most_cells(std::size_t items) { return 4 * items + 1; }
  // From so many entries on, looking at each of a cell's is dearer than another level.
  static constexpr std::size_t kCrowded = 64;
  // A cell is split into cells of at most this part of its side, or not at all.
  static constexpr double kLeastSplit = 0.25;

  // Sorts by cell, stably, on all threads.
  CellEntries enter_all(const CellFrame& frame) const {
    std::vector<std::uint32_t> offsets(items_.size());
    parallel::for_each(items_.size(), [&](std::size_t i) {
      std::uint32_t count = 0;
      items_.for_each_cell(frame, i, [&](std::size_t) { ++count; });
      offsets[i] = count;
    });
    const std::uint32_t total = parallel::exclusive_scan(std::span(offsets));
    std::vector<std::uint64_t> cells(total);
    CellEntries result;
    result.ids.resize(total);
    parallel::for_each(items_.size(), [&](std::size_t i) {
      std::uint32_t at = offsets[i];
      items_.for_each_cell(frame, i, [&](std::size_t cell) {
        cells[at] = cell;
        result.ids[at++] = static_cast<std::uint32_t>(i);
      });
    });
    parallel::stable_sort_by_key(cells, result.ids);
    result.begin.assign(frame.size() + 1, total);
    // Each entry that is the first of its cell begins that, and the empty ones before it.
    parallel::for_each(total, [&](std::size_t i) {
      const std::size_t after_last = i == 0 ? 0 : cells[i - 1] + 1;
      for (std::size_t cell = after_last; cell <= cells[i]; ++cell)
        result.begin[cell] = static_cast<std::uint32_t>(i);
    });
    return result;
  }

  // The same for the few of a cell.
  CellEntries enter(std::span<const std::uint32_t> ids, const CellFrame& frame) const {
    CellEntries result;
    result.begin.assign(frame.size() + 1, 0);
    for (const std::uint32_t id : ids)
      items_.for_each_cell(frame, id, [&](std::size_t cell) { ++result.begin[cell]; });
    std::exclusive_scan(result.begin.begin(), result.begin.end(), result.begin.begin(), 0U);
    result.ids.resize(result.begin.back());
    std::vector<std::uint32_t> next = result.begin;
    for (const std::uint32_t id : ids)
      items_.for_each_cell(frame, id, [&](std::size_t cell) { result.ids[next[cell]++] = id; });
    return result;
  }

  struct Split {
    CellFrame frame;
    CellEntries entries;
  };

  // Items that run through much of the cell, as a bundle of long segments, would stand in many of the smaller
  // cells, and still crowd each of them: the mean length says how small cells may be.
  std::optional<Split> split_of(std::span<const std::uint32_t> ids, const CellFrame& frame,
                                std::size_t cell) const {
    const Box2 within = frame.box(cell);
    Box2 box;
    double length = 0;
    for (const std::uint32_t id : ids) length += items_.extend(box, id, within);
    const double side = std::max({side_, length / static_cast<double>(ids.size()), 4 * frame.slack()});
    if (box.empty() || side > kLeastSplit * frame.side()) return std::nullopt;
    const CellFrame smaller = frame.within(box, side, most_cells(ids.size()));
    if (smaller.side() > kLeastSplit * frame.side()) return std::nullopt;
    return Split{smaller, enter(ids, smaller)};
  }

  void split_crowded(CellTree& tree, std::size_t part) const {
    const auto [frame, first_cell] = tree.parts()[part];
    if (side_ > kLeastSplit * frame.side()) return;
    const std::vector<std::uint32_t> crowded = parallel::filter_indices(
        frame.size(), [&](std::size_t cell) { return tree.entries(first_cell + cell).size() > kCrowded; });
    std::vector<std::optional<Split>> splits(crowded.size());
    parallel::for_each(
        crowded.size(),
        [&](std::size_t i) {
          splits[i] = split_of(tree.entries(first_cell + crowded[i]), frame, crowded[i]);
        },
        1);
    for (std::size_t i = 0; i < crowded.size(); ++i)
      if (splits[i]) tree.split(first_cell + crowded[i], splits[i]->frame, splits[i]->entries);
  }

  const Items& items_;
  double side_;
};

}  // namespace quarry
