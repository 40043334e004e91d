// Finds what stands under a number of a file: numbers are dense in nearly all files, and may be anything.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace quarry {

class NumberIndex {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // False if the number is taken.
  bool add(std::int64_t number, std::uint32_t index) {
    if (find(number) != kNone) return false;
    ++count_;
    if (number < 0 || number >= std::max(kAlwaysDense, kSlotsForEach * count_)) {
      sparse_.emplace(number, index);
      return true;
    }
    const auto slot = static_cast<std::size_t>(number);
    if (slot >= dense_.size()) dense_.resize(std::max(slot + 1, 2 * dense_.size()), kNone);
    dense_[slot] = index;
    return true;
  }
  // The index under a number, or kNone.
  [[nodiscard]] std::uint32_t find(std::int64_t number) const {
    if (number >= 0 && number < static_cast<std::int64_t>(dense_.size())) {
      const std::uint32_t index = dense_[static_cast<std::size_t>(number)];
      if (index != kNone || sparse_.empty()) return index;
    }
    const auto found = sparse_.find(number);
    return found == sparse_.end() ? kNone : found->second;
  }

 private:
  // What a small file may ask of memory is small, whatever its numbers are.
  static constexpr std::int64_t kAlwaysDense = 1 << 12;
  static constexpr std::int64_t kSlotsForEach = 16;

  std::vector<std::uint32_t> dense_;
  std::unordered_map<std::int64_t, std::uint32_t> sparse_;
  std::int64_t count_ = 0;
};

}  // namespace quarry
