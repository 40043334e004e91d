#include "io/picture/paint_order.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>

namespace quarry {

std::vector<std::uint32_t> paint_order(const std::vector<double>& depths,
                                       std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::uint32_t> by_depth(depths.size());
  std::iota(by_depth.begin(), by_depth.end(), 0U);
  std::stable_sort(by_depth.begin(), by_depth.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return depths[a] < depths[b]; });
  std::vector<std::uint32_t> rank(depths.size());
  for (std::uint32_t i = 0; i < by_depth.size(); ++i) rank[by_depth[i]] = i;
  std::vector<std::uint32_t> waits_for(depths.size(), 0);
  for (const auto& [before, after] : pairs) ++waits_for[after];

  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready;  // ranks
  for (std::uint32_t shape = 0; shape < depths.size(); ++shape)
    if (waits_for[shape] == 0) ready.push(rank[shape]);
  std::vector<std::uint8_t> done(depths.size(), 0);
  std::vector<std::uint32_t> order;
  std::size_t farthest = 0;  // in by_depth; all before it are done
  while (order.size() < depths.size()) {
    while (done[by_depth[farthest]] != 0) ++farthest;
    const std::uint32_t shape = by_depth[ready.empty() ? farthest : ready.top()];
    if (!ready.empty()) ready.pop();
    if (done[shape] != 0) continue;
    done[shape] = 1;
    order.push_back(shape);
    const auto first = std::lower_bound(pairs.begin(), pairs.end(), std::pair(shape, 0U));
    for (auto pair = first; pair != pairs.end() && pair->first == shape; ++pair)
      if (--waits_for[pair->second] == 0) ready.push(rank[pair->second]);
  }
  return order;
}

}  // namespace quarry
