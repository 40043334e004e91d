// T-joins: sets of edges of a graph that touch each odd node an odd number of times and every other node an
// even number of times. They are ways between odd nodes, two by two: the cheapest one is a perfect matching
// of these by the costs of their shortest ways.
//   J. Edmonds, E. L. Johnson: Matching, Euler tours and the Chinese postman. Mathematical Programming 5,
//   1973.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace quarry::matching {

struct JoinEdge {
  std::uint32_t a = 0, b = 0;  // two different nodes
  std::int64_t cost = 1;       // positive; sums along ways fit
};

struct JoinProblem {
  std::span<const std::uint8_t> odd;  // by node: 1 if odd
  std::span<const JoinEdge> edges;
  std::uint32_t free;  // a node that may be touched any number of times; not odd
};

struct TJoin {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<std::uint32_t> edges;  // ascending
  // An odd node of a part that does not reach the free node and has an odd number of odd nodes: then there
  // is no T-join, and no edges are given.
  std::uint32_t stuck = kNone;
};

// From the pairs that meet along a tree of cheapest ways, exchanges partners along chains of up to nine pairs
// while the sum of costs falls (as Lin & Kernighan 1973 do for tours). Tests with up to fourteen odd nodes
// find nothing cheaper; of many that is not proved. Of equally cheap ones always the same. Serial: 90,000
// regions take about a second.
[[nodiscard]] TJoin cheap_t_join(const JoinProblem& problem);

}  // namespace quarry::matching
