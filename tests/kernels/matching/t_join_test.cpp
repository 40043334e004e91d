#include "kernels/matching/t_join.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

using matching::JoinEdge;

struct RandomGraph {
  std::vector<std::uint8_t> odd;
  std::vector<JoinEdge> edges;
  std::uint32_t free = 0;

  // The free node is the last; it may have no edge.
  RandomGraph(std::mt19937_64& random, std::uint32_t nodes, std::uint32_t edge_count, std::uint64_t dearest)
      : odd(nodes, 0), free(nodes - 1) {
    for (std::uint32_t i = 0; i < free; ++i) odd[i] = static_cast<std::uint8_t>(random() % 2);
    for (std::uint32_t i = 0; i < edge_count; ++i) {
      const auto a = static_cast<std::uint32_t>(random() % nodes);
      const auto b = static_cast<std::uint32_t>(random() % (nodes - 1));
      const auto cost = 1 + static_cast<std::int64_t>(random() % dearest);
      edges.push_back({a, b < a ? b : b + 1, cost});
    }
  }

  // What a set of edges costs, if it is a T-join.
  template <class Contains>
  [[nodiscard]] std::optional<std::int64_t> cost_of(const Contains& contains) const {
    std::vector<std::uint8_t> left = odd;
    std::int64_t cost = 0;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (!contains(i)) continue;
      left[edges[i].a] ^= 1U;
      left[edges[i].b] ^= 1U;
      cost += edges[i].cost;
    }
    left[free] = 0;
    if (std::find(left.begin(), left.end(), 1) != left.end()) return std::nullopt;
    return cost;
  }

  // The least cost of all sets of edges; none where no set is a T-join.
  [[nodiscard]] std::optional<std::int64_t> least_cost() const {
    std::optional<std::int64_t> least;
    for (std::uint32_t set = 0; set < (1U << edges.size()); ++set) {
      const auto cost = cost_of([&](std::uint32_t i) { return ((set >> i) & 1U) != 0; });
      if (cost && (!least || *cost < *least)) least = cost;
    }
    return least;
  }
};

void expect_cheapest(const RandomGraph& graph) {
  const matching::TJoin join = matching::cheap_t_join({graph.odd, graph.edges, graph.free});
  const std::optional<std::int64_t> least = graph.least_cost();
  EXPECT_EQ(join.stuck == matching::TJoin::kNone, least.has_value());
  if (!least) return;
  const auto cost = graph.cost_of(
      [&](std::uint32_t i) { return std::binary_search(join.edges.begin(), join.edges.end(), i); });
  ASSERT_TRUE(cost.has_value());
  EXPECT_EQ(*cost, *least);
}

TEST(TJoin, IsTheCheapestOfAllOnSmallGraphs) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const auto nodes = static_cast<std::uint32_t>(3 + random() % 10);
    const auto edges = static_cast<std::uint32_t>(random() % 15);
    expect_cheapest(RandomGraph(random, nodes, edges, 1 + seed % 4));
  }
}

// What it costs at least by the theorem: the cheapest way to join all odd nodes two by two, or with the free
// node, by the costs of the cheapest ways between them.
std::int64_t cheapest_pairs(const RandomGraph& graph) {
  constexpr std::int64_t kFar = std::int64_t{1} << 40;
  const std::size_t size = graph.odd.size();
  std::vector<std::vector<std::int64_t>> cost(size, std::vector<std::int64_t>(size, kFar));
  for (const JoinEdge& edge : graph.edges)
    for (const auto& [a, b] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)})
      cost[a][b] = std::min(cost[a][b], edge.cost);
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) cost[i][j] = std::min(cost[i][j], cost[i][k] + cost[k][j]);
  std::vector<std::size_t> odd;
  for (std::size_t i = 0; i < size; ++i)
    if (graph.odd[i] != 0) odd.push_back(i);
  // By the set of those that are joined: the first of the others is joined next.
  std::vector<std::int64_t> least(std::size_t{1} << odd.size(), kFar);
  least[0] = 0;
  for (std::size_t set = 0; set + 1 < least.size(); ++set) {
    std::size_t i = 0;
    while (((set >> i) & 1U) != 0) ++i;
    const auto offer = [&](std::size_t with, std::int64_t more) {
      least[with] = std::min(least[with], least[set] + more);
    };
    offer(set | (std::size_t{1} << i), cost[odd[i]][graph.free]);
    for (std::size_t j = i + 1; j < odd.size(); ++j)
      if (((set >> j) & 1U) == 0)
        offer(set | (std::size_t{1} << i) | (std::size_t{1} << j), cost[odd[i]][odd[j]]);
  }
  return least.back();
}

TEST(TJoin, IsTheCheapestMatchingOfUpToFourteenOddNodes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const auto nodes = static_cast<std::uint32_t>(20 + random() % 40);
    RandomGraph graph(random, nodes, 3 * nodes, 1 + 3 * (seed % 3));
    std::size_t count = 0;
    for (std::uint8_t& odd : graph.odd) odd = odd != 0 && ++count <= 14 ? 1 : 0;
    const matching::TJoin join = matching::cheap_t_join({graph.odd, graph.edges, graph.free});
    if (join.stuck != matching::TJoin::kNone) continue;
    const auto cost = graph.cost_of(
        [&](std::uint32_t i) { return std::binary_search(join.edges.begin(), join.edges.end(), i); });
    ASSERT_TRUE(cost.has_value());
    EXPECT_EQ(*cost, cheapest_pairs(graph));
  }
}

TEST(TJoin, NamesANodeOfAPartThatHasNone) {
  const std::vector<std::uint8_t> odd = {0, 1, 0, 1, 1, 1, 0};
  const std::vector<JoinEdge> edges = {{0, 1}, {1, 6}, {2, 3}, {3, 4}, {4, 5}};
  const matching::TJoin join = matching::cheap_t_join({odd, edges, 6});
  EXPECT_GE(join.stuck, 3U);
  EXPECT_LE(join.stuck, 5U);
}

// A path of odd nodes: the tree from its middle leaves a pair that crosses it.
TEST(TJoin, HasEveryOtherEdgeOfAnOddPath) {
  std::vector<std::uint8_t> odd(1001, 1);
  odd.back() = 0;
  std::vector<JoinEdge> edges;
  for (std::uint32_t i = 0; i + 1 < 1000; ++i) edges.push_back({i, i + 1});
  const matching::TJoin join = matching::cheap_t_join({odd, edges, 1000});
  ASSERT_EQ(join.edges.size(), 500U);
  for (std::uint32_t i = 0; i < 500; ++i) EXPECT_EQ(join.edges[i], 2 * i);
}

}  // namespace
}  // namespace quarry
