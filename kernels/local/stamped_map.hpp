// A hash map of 64-bit keys for small jobs that come one after the other: it is emptied in constant time, and
// keeps its memory, so that a steady stream of jobs allocates nothing.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/base/random.hpp"

namespace quarry {

// The key of a directed side, and of a vertex.
constexpr std::uint64_t stamped_key(VertexId from, VertexId to) {
  return (std::uint64_t{from.value()} << 32) | to.value();
}
constexpr std::uint64_t stamped_key(VertexId v) { return v.value(); }
constexpr std::uint64_t stamped_key(FaceId f) { return f.value(); }

template <class Value>
class StampedMap {
 public:
  // Forgets all keys and makes room for at most so many. Only as many slots are used as this number asks
  // for: a small job after a large one stays in cache.
  void clear(std::size_t most_keys) {
    const std::size_t size = std::bit_ceil(2 * most_keys + 2);
    if (slots_.size() < size) slots_.resize(size);
    mask_ = size - 1;
    if (++stamp_ != 0) return;
    for (Slot& slot : slots_) slot.stamp = 0;
    stamp_ = 1;
  }

  // The value of a key, or none.
  [[nodiscard]] Value* find(std::uint64_t key) {
    Slot& slot = slot_of(key);
    return slot.stamp == stamp_ ? &slot.value : nullptr;
  }

  struct Inserted {
    Value& value;  // stays where it is until clear()
    bool is_new;
  };
  // The value of a key; Value() if the key is new.
  Inserted insert(std::uint64_t key) {
    Slot& slot = slot_of(key);
    if (slot.stamp == stamp_) return {slot.value, false};
    slot = {key, stamp_, Value()};
    return {slot.value, true};
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t stamp = 0;
    Value value{};
  };

  // The slot of the key, or the empty one where it belongs. At most half of the slots are taken.
  Slot& slot_of(std::uint64_t key) {
    assert(stamp_ != 0);
    std::size_t at = mix64(key) & mask_;
    while (slots_[at].stamp == stamp_ && slots_[at].key != key) at = (at + 1) & mask_;
    return slots_[at];
  }

  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
  std::uint32_t stamp_ = 0;
};

}  // namespace quarry
