// The input lines at numbered places (nodes, edges), in compressed rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::linework {

class LinesAt {
 public:
  // pairs: a place below `places` and a line there, in any order, again and again or not.
  LinesAt(std::size_t places, const std::vector<std::pair<std::uint32_t, LineId>>& pairs)
      : begin_(places + 1, 0), end_(places), lines_(pairs.size()) {
    for (const auto& [place, line] : pairs) ++begin_[place];
    (void)parallel::exclusive_scan(std::span(begin_));
    std::copy(begin_.begin(), begin_.end() - 1, end_.begin());
    for (const auto& [place, line] : pairs) lines_[end_[place]++] = line;
    parallel::for_each(places, [&](std::size_t place) {
      LineId* first = lines_.data() + begin_[place];
      LineId* last = lines_.data() + end_[place];
      std::sort(first, last);
      end_[place] = static_cast<std::size_t>(std::unique(first, last) - lines_.data());
    });
  }

  // Ascending, each once.
  [[nodiscard]] std::span<const LineId> at(std::uint32_t place) const {
    return {lines_.data() + begin_[place], lines_.data() + end_[place]};
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> end_;
  std::vector<LineId> lines_;
};

}  // namespace quarry::linework
