// The edges (pieces, links, ...) that end at each node, in compressed rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

// NumberOf: what the edges are numbered by, from 0, in their own order.
template <class NumberOf>
class EndsAround {
 public:
  // Edges have members `from` and `to`, nodes below `nodes`; those that begin and end at one node stand there
  // twice.
  template <class Edges>
  EndsAround(std::size_t nodes, const Edges& edges) : begin_(nodes + 1, 0) {
    for (const auto& edge : edges) {
      ++begin_[edge.from.value()];
      ++begin_[edge.to.value()];
    }
    (void)parallel::exclusive_scan(std::span(begin_));
    numbers_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    std::uint32_t number = 0;
    for (const auto& edge : edges) {
      numbers_[next[edge.from.value()]++] = NumberOf(number);
      numbers_[next[edge.to.value()]++] = NumberOf(number);
      ++number;
    }
  }

  // Ascending.
  [[nodiscard]] std::span<const NumberOf> at(NodeId node) const {
    const std::uint32_t begin = begin_[node.value()];
    return std::span(numbers_).subspan(begin, begin_[node.value() + 1] - begin);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<NumberOf> numbers_;
};

}  // namespace quarry
