// Many short lists of numbers in one array, which may grow: a list that outgrows its place moves to the end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quarry::linework {

class GrowingRows {
 public:
  // sizes: how many numbers are to come into each row at first.
  explicit GrowingRows(const std::vector<std::uint32_t>& sizes) : rows_(sizes.size()) {
    std::size_t total = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      rows_[i] = {total, 0, sizes[i]};
      total += sizes[i];
    }
    values_.resize(total);
  }

  // In the order in which they came; valid until something is added.
  [[nodiscard]] std::span<const std::uint32_t> at(std::size_t row) const {
    return std::span(values_).subspan(rows_[row].begin, rows_[row].size);
  }

  void add(std::size_t row, std::uint32_t value) {
    Row& r = rows_[row];
    if (r.size == r.capacity) {
      const std::size_t from = r.begin;
      r.begin = values_.size();
      r.capacity = 2 * r.capacity + 2;
      values_.resize(values_.size() + r.capacity);
      std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(from), r.size,
                  values_.begin() + static_cast<std::ptrdiff_t>(r.begin));
    }
    values_[r.begin + r.size++] = value;
  }

  void remove(std::size_t row, std::uint32_t value) {
    Row& r = rows_[row];
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(r.begin);
    r.size = static_cast<std::uint32_t>(std::remove(first, first + r.size, value) - first);
  }

  void clear(std::size_t row) { rows_[row].size = 0; }

 private:
  struct Row {
    std::size_t begin;
    std::uint32_t size;
    std::uint32_t capacity;
  };
  std::vector<Row> rows_;
  std::vector<std::uint32_t> values_;
};

}  // namespace quarry::linework
