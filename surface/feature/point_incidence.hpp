// Which edges, or triangles, meet at each point of a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace quarry {

class PointIncidence {
 public:
  // points_of(item): a range of the points, below `points`, of each item below `items`.
  template <class PointsOf>
  PointIncidence(std::size_t points, std::size_t items, const PointsOf& points_of) : begin_(points + 1, 0) {
    for (std::size_t item = 0; item < items; ++item)
      for (const std::uint32_t p : points_of(item)) ++begin_[p + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t item = 0; item < items; ++item)
      for (const std::uint32_t p : points_of(item)) items_[next[p]++] = static_cast<std::uint32_t>(item);
  }

  [[nodiscard]] std::size_t points() const { return begin_.size() - 1; }
  // The items at a point, ascending.
  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t p) const {
    return std::span(items_).subspan(begin_[p], begin_[p + 1] - begin_[p]);
  }

 private:
  std::vector<std::uint32_t> begin_, items_;
};

}  // namespace quarry
