#include "kernels/matching/t_join.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "kernels/matching/cheapest_ways.hpp"

namespace quarry::matching {
namespace {

// Which odd nodes are joined, and what their ways cost. The partner `free` may have many.
struct Pairs {
  std::vector<Node> partner;
  std::vector<Cost> cost;

  void join(Node a, Node b, Node free, Cost of_way) {
    partner[a] = b;
    cost[a] = of_way;
    if (b == free) return;
    partner[b] = a;
    cost[b] = of_way;
  }
};

// Exchanges partners along chains: a pair is parted, one of the two joined to an odd node nearby, whose
// partner is joined to the next, until the last one is joined to the other of the first pair. What is parted
// has cost more than what is joined.
class PairExchange {
 public:
  struct Near {
    Node node;
    Cost cost;
  };

  PairExchange(const JoinProblem& problem, const JoinGraph& graph, std::span<const Cost> to_free,
               Pairs& pairs)
      : free_(problem.free), to_free_(to_free), pairs_(pairs), near_(graph.size()), parted_(graph.size()) {
    CheapestWays ways(graph);
    for (Node r = 0; r < graph.size(); ++r) {
      if (problem.odd[r] == 0) continue;
      odd_.push_back(r);
      ways.find_from(r, [&](Node to, Cost cost) {
        if (to != r && problem.odd[to] != 0) near_[r].push_back({to, cost});
        return near_[r].size() == kBreadth.front();
      });
    }
  }

  void run() {
    for (const Node r : odd_) credit_ += pairs_.cost[r];
    credit_ = 2 * (credit_ / static_cast<Cost>(odd_.size() + 1));
    for (bool better = true; better;) {
      better = false;
      for (const Node r : odd_) better |= improve_from(r);
    }
  }

 private:
  // How many neighbours are tried at each step of a chain.
  static constexpr std::array<std::size_t, 8> kBreadth = {12, 8, 6, 5, 4, 3, 2, 2};

  struct Joined {
    Node a, b;
    Cost cost;
  };

  bool improve_from(Node r) {
    const Node partner = pairs_.partner[r];
    chain_.clear();
    part(r, true);
    const bool better =
        partner == free_ ? grow(r, free_, pairs_.cost[r], 0) : grow(partner, r, pairs_.cost[r], 0);
    part(r, false);
    if (!better) return false;
    // With their old partners.
    for (const auto& [a, b, cost] : chain_)
      for (const Node end : {a, b})
        if (end != free_) part(end, false);
    for (const auto& [a, b, cost] : chain_) pairs_.join(a, b, free_, cost);
    return true;
  }

  // Both ends of a chain are to be joined to something; `waiting` may be the free node, and then needs not.
  // Of a ring of pairs, one can be parted first such that the gain never falls to nothing on the way round.
  // Of a chain between two ways to the free node, grown from its middle to both ends, that is not so: its
  // second half may be in debt before it ends.
  bool grow(Node loose, Node waiting, Cost gain, std::size_t step) {
    if (close(loose, waiting, gain, step)) return true;
    if (step == kBreadth.size()) return false;
    const Cost most = waiting == free_ ? gain + credit_ : gain;
    std::size_t tried = 0;
    for (const auto& [to, cost] : near_[loose]) {
      if (cost >= most || tried == kBreadth[step]) return false;
      if (parted_[to] != 0) continue;
      ++tried;
      const Cost left = gain - cost + pairs_.cost[to];
      const Node next = pairs_.partner[to];
      part(to, true);
      chain_.push_back({loose, to, cost});
      if (goes_on(next, waiting, left, step + 1)) return true;
      chain_.pop_back();
      part(to, false);
    }
    return false;
  }

  bool goes_on(Node loose, Node waiting, Cost gain, std::size_t step) {
    if (loose != free_) return grow(loose, waiting, gain, step);
    if (waiting != free_) return grow(waiting, free_, gain, step);
    return gain > 0;
  }

  bool close(Node loose, Node waiting, Cost gain, std::size_t step) {
    if (waiting != free_) {
      const Cost cost = cost_between(loose, waiting);
      if (cost < gain) {
        chain_.push_back({loose, waiting, cost});
        return true;
      }
    }
    const Cost to_free = to_free_[loose];
    if (to_free >= gain) return false;
    chain_.push_back({loose, free_, to_free});
    if (waiting == free_ || grow(waiting, free_, gain - to_free, step)) return true;
    chain_.pop_back();
    return false;
  }

  // As far as one is among those near to the other.
  [[nodiscard]] Cost cost_between(Node a, Node b) const {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
      for (const Near& near : near_[from])
        if (near.node == to) return near.cost;
    return kFar;
  }

  void part(Node r, bool parted) {
    parted_[r] = parted ? 1 : 0;
    if (pairs_.partner[r] != free_) parted_[pairs_.partner[r]] = parted_[r];
  }

  Node free_;
  Cost credit_ = 0;                // twice what a pair costs in the mean
  std::span<const Cost> to_free_;  // what the way from each node there costs
  Pairs& pairs_;
  std::vector<std::vector<Near>> near_;  // of odd nodes: others nearby, by cost
  std::vector<std::uint8_t> parted_;
  std::vector<Node> odd_;
  std::vector<Joined> chain_;
};

class JoinFinder {
 public:
  explicit JoinFinder(const JoinProblem& problem) : problem_(problem), graph_(problem), forest_(graph_) {}

  TJoin run() {
    grow_forest();
    TJoin join;
    join.stuck = pair_along_forest();
    if (join.stuck != kNone) return join;
    PairExchange(problem_, graph_, to_free_, pairs_).run();
    join.edges = edges_of_ways();
    return join;
  }

 private:
  // Trees of cheapest ways: from the free node, and from the first node of each part that does not reach it.
  void grow_forest() {
    const auto visit = [&](Node r, Cost) {
      order_.push_back(r);
      return false;
    };
    forest_.find_from(problem_.free, visit);
    to_free_ = forest_.costs();
    for (Node r = 0; r < graph_.size(); ++r)
      if (!forest_.reached(r)) forest_.find_from(r, visit, false);
  }

  // From the leaves on, odd nodes whose ways up the tree meet are joined. Returns an odd node that is left
  // without a partner, or none.
  Node pair_along_forest() {
    pairs_.partner.assign(graph_.size(), kNone);
    pairs_.cost.assign(graph_.size(), 0);
    std::vector<Node> coming(graph_.size(), kNone);  // by node: the odd one whose way has come so far
    const auto come = [&](Node r, Node at) {
      const Node other = std::exchange(coming[at], coming[at] == kNone ? r : kNone);
      if (other != kNone)
        pairs_.join(r, other, problem_.free, forest_.cost(r) + forest_.cost(other) - 2 * forest_.cost(at));
    };
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
      const Node at = *it;
      if (problem_.odd[at] != 0) come(at, at);
      const Node r = coming[at];
      if (r == kNone) continue;
      if (at == problem_.free)
        pairs_.join(r, at, at, forest_.cost(r));
      else if (forest_.through(at) == kNone)
        return r;
      else
        come(r, graph_.across(forest_.through(at), at));
    }
    return kNone;
  }

  std::vector<std::uint32_t> edges_of_ways() {
    std::vector<std::uint8_t> chosen(problem_.edges.size(), 0);
    CheapestWays ways(graph_);
    for (Node r = 0; r < graph_.size(); ++r) {
      if (problem_.odd[r] == 0) continue;
      const Node to = pairs_.partner[r];
      if (to == problem_.free) {
        forest_.toggle_way(r, chosen);
      } else if (r < to) {
        ways.find_from(r, [&](Node reached, Cost) { return reached == to; });
        ways.toggle_way(to, chosen);
      }
    }
    std::vector<std::uint32_t> edges;
    for (std::uint32_t i = 0; i < chosen.size(); ++i)
      if (chosen[i] != 0) edges.push_back(i);
    return edges;
  }

  const JoinProblem& problem_;
  JoinGraph graph_;
  CheapestWays forest_;
  std::vector<Cost> to_free_;
  std::vector<Node> order_;  // as the forest grew
  Pairs pairs_;
};

}  // namespace

TJoin cheap_t_join(const JoinProblem& problem) { return JoinFinder(problem).run(); }

}  // namespace quarry::matching
