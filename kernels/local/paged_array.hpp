// An array over all entities of a mesh of which a small job touches few, near one another: pages come when
// they are first written, so that memory and the time to forget all follow what is touched. As ids along a
// Hilbert curve are near one another where their entities are, a patch of n faces touches about n / 20 pages.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace quarry {

template <class IdType, class T>
class PagedArray {
 public:
  // Forgets all values, and makes room for ids below `size`.
  void clear(std::size_t size) {
    for (const std::uint32_t place : touched_) table_[place] = &blank_;
    touched_.clear();
    const std::size_t places = (size + kPage - 1) / kPage;
    if (table_.size() < places) table_.resize(places, &blank_);
  }

  // T() where nothing was written since the last clear().
  [[nodiscard]] const T& get(IdType id) const { return (*table_[id.value() / kPage])[id.value() % kPage]; }
  // May be written; stays valid until the next clear().
  [[nodiscard]] T& at(IdType id) {
    Page*& page = table_[id.value() / kPage];
    if (page == &blank_) page = take_page(id.value() / kPage);
    return (*page)[id.value() % kPage];
  }

  PagedArray() = default;
  PagedArray(const PagedArray&) = delete;
  PagedArray& operator=(const PagedArray&) = delete;

 private:
  static constexpr std::uint32_t kPage = 64;
  using Page = std::array<T, kPage>;

  Page* take_page(std::uint32_t place) {
    if (pages_.size() == touched_.size()) pages_.push_back(std::make_unique<Page>());
    Page* page = pages_[touched_.size()].get();
    touched_.push_back(place);
    page->fill(T());
    return page;
  }

  Page blank_{};                        // what is read where nothing was written
  std::vector<Page*> table_;            // the page of each 64 ids, or the blank one
  std::vector<std::uint32_t> touched_;  // places in the table, in the order of their pages
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace quarry
