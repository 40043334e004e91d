// The graph of a T-join in compressed rows, and the cheapest ways through it (E. W. Dijkstra: A note on two
// problems in connexion with graphs. Numerische Mathematik 1, 1959).
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "kernels/matching/t_join.hpp"

namespace quarry::matching {

using Node = std::uint32_t;
using Cost = std::int64_t;

inline constexpr Node kNone = TJoin::kNone;
inline constexpr Cost kFar = std::numeric_limits<Cost>::max();

// The edges of each node in compressed rows.
class JoinGraph {
 public:
  explicit JoinGraph(const JoinProblem& problem) : edges_(problem.edges), begin_(problem.odd.size() + 1, 0) {
    for (const JoinEdge& edge : edges_)
      for (const Node r : {edge.a, edge.b}) ++begin_[r + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    at_.resize(2 * edges_.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < edges_.size(); ++i)
      for (const Node r : {edges_[i].a, edges_[i].b}) at_[next[r]++] = i;
  }

  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> edges_at(Node r) const {
    return std::span(at_).subspan(begin_[r], begin_[r + 1] - begin_[r]);
  }
  [[nodiscard]] Node across(std::uint32_t edge, Node r) const {
    return edges_[edge].a == r ? edges_[edge].b : edges_[edge].a;
  }
  [[nodiscard]] Cost cost(std::uint32_t edge) const { return edges_[edge].cost; }

 private:
  std::span<const JoinEdge> edges_;
  std::vector<std::uint32_t> begin_, at_;
};

// The cheapest ways from one node, by Dijkstra's algorithm, as far as they are wanted.
class CheapestWays {
 public:
  explicit CheapestWays(const JoinGraph& graph)
      : graph_(graph), cost_(graph.size(), kFar), through_(graph.size(), kNone) {}

  // Calls enough(node, cost) for one node after the other, by cost and then by number, until it says so.
  // With forget = false, what was reached before stays as it is: the next tree of a forest.
  template <class Enough>
  void find_from(Node start, const Enough& enough, bool forget = true) {
    if (forget) {
      for (const Node r : touched_) cost_[r] = kFar;
      touched_.clear();
    }
    Queue queue;
    reach(queue, start, 0, kNone);
    while (!queue.empty()) {
      const auto [cost, r] = queue.top();
      queue.pop();
      if (cost > cost_[r]) continue;
      if (enough(r, cost)) return;
      for (const std::uint32_t edge : graph_.edges_at(r))
        if (const Node to = graph_.across(edge, r); cost + graph_.cost(edge) < cost_[to])
          reach(queue, to, cost + graph_.cost(edge), edge);
    }
  }

  [[nodiscard]] bool reached(Node r) const { return cost_[r] != kFar; }
  // By node, kFar where it was not reached.
  [[nodiscard]] const std::vector<Cost>& costs() const { return cost_; }
  [[nodiscard]] Cost cost(Node r) const { return cost_[r]; }
  // The edge through which a node was reached; none at the start.
  [[nodiscard]] std::uint32_t through(Node r) const { return through_[r]; }
  // Puts the edges of the way to a node in, or takes them out.
  void toggle_way(Node r, std::vector<std::uint8_t>& chosen) const {
    for (; through_[r] != kNone; r = graph_.across(through_[r], r)) chosen[through_[r]] ^= 1U;
  }

 private:
  using Queue =
      std::priority_queue<std::pair<Cost, Node>, std::vector<std::pair<Cost, Node>>, std::greater<>>;

  void reach(Queue& queue, Node r, Cost cost, std::uint32_t edge) {
    if (cost_[r] == kFar) touched_.push_back(r);
    cost_[r] = cost;
    through_[r] = edge;
    queue.emplace(cost, r);
  }

  const JoinGraph& graph_;
  std::vector<Cost> cost_;
  std::vector<std::uint32_t> through_;
  std::vector<Node> touched_;
};

}  // namespace quarry::matching
