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
    if (number < 0 || number >= kDense) return sparse_.emplace(number, index).second;
    const auto slot = static_cast<std::size_t>(number);
    if (slot >= dense_.size()) dense_.resize(std::max(slot + 1, 2 * dense_.size()), kNone);
    if (dense_[slot] != kNone) return false;
    dense_[slot] = index;
    return true;
  }
  // The index under a number, or kNone.
  [[nodiscard]] std::uint32_t find(std::int64_t number) const {
    if (number >= 0 && number < kDense) {
      const auto slot = static_cast<std::size_t>(number);
      return slot < dense_.size() ? dense_[slot] : kNone;
    }
    const auto found = sparse_.find(number);
    return found == sparse_.end() ? kNone : found->second;
  }

 private:
  static constexpr std::int64_t kDense = std::int64_t{1} << 26;
  std::vector<std::uint32_t> dense_;
  std::unordered_map<std::int64_t, std::uint32_t> sparse_;
};

}  // namespace quarry
