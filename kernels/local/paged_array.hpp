// An array over all entities of a mesh of which a small job touches few, near one another: pages come when
// they are first written, so that memory and the time to forget all follow what is touched. As ids along a
// Hilbert curve are near one another where their entities are, a patch of n faces touches about n / 20 pages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quarry {

template <class IdType, class T>
class PagedArray {
 public:
  // Forgets all values, and makes room for ids below `size`.
  void clear(std::size_t size) {
    for (const std::uint32_t place : touched_) table_[place] = kNone;
    touched_.clear();
    const std::size_t places = (size + kPage - 1) / kPage;
    if (table_.size() < places) table_.resize(places, kNone);
  }

  // T() where nothing was written since the last clear().
  [[nodiscard]] T get(IdType id) const {
    const std::uint32_t page = table_[id.value() / kPage];
    return page == kNone ? T() : pages_[page][id.value() % kPage];
  }
  // May be written; stays valid until the next call.
  [[nodiscard]] T& at(IdType id) {
    std::uint32_t& page = table_[id.value() / kPage];
    if (page == kNone) {
      page = static_cast<std::uint32_t>(touched_.size());
      touched_.push_back(id.value() / kPage);
      if (pages_.size() < touched_.size()) pages_.emplace_back();
      pages_[page].fill(T());
    }
    return pages_[page][id.value() % kPage];
  }

 private:
  static constexpr std::uint32_t kPage = 64;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> table_;    // the page of each 64 ids, or kNone
  std::vector<std::uint32_t> touched_;  // places in the table, in the order of their pages
  std::vector<std::array<T, kPage>> pages_;
};

}  // namespace quarry
