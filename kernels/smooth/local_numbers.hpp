// Numbers the vertices of a region from 0 in the order in which they are met, at a cost that depends on the
// region alone.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/base/random.hpp"

namespace quarry {

class LocalNumbers {
 public:
  // Forgets all numbers, and makes room for about so many.
  void clear(std::size_t expected) {
    const std::size_t wanted = std::bit_ceil(2 * expected + 16);
    count_ = 0;
    if (++epoch_ == 0 || slots_.size() < wanted) {
      slots_.assign(std::max(wanted, slots_.size()), Slot{});
      epoch_ = 1;
    }
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }

  // The number of v, and whether it is new.
  std::pair<std::uint32_t, bool> number(VertexId v) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = find(v);
    if (slot.epoch == epoch_) return {slot.number, false};
    slot = {v, epoch_, count_};
    return {count_++, true};
  }

 private:
  struct Slot {
    VertexId vertex;
    std::uint32_t epoch = 0;
    std::uint32_t number = 0;
  };

  Slot& find(VertexId v) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = mix32(v.value()) & mask;
    while (slots_[at].epoch == epoch_ && slots_[at].vertex != v) at = (at + 1) & mask;
    return slots_[at];
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.epoch == epoch_) find(slot.vertex) = slot;
  }

  std::vector<Slot> slots_;  // a power of two of them, at most half in use
  std::uint32_t epoch_ = 0;
  std::uint32_t count_ = 0;
};

}  // namespace quarry
