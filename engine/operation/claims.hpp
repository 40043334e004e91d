// The claim words of passes over one mesh, one a vertex: 32 bits of inverted round number over 32 bits of
// rank, so that a claim of a newer round is always smaller and nothing is ever cleared. Rounds are counted
// over all passes that share them: short passes over a large mesh need not visit all of its vertices first.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/id.hpp"

namespace quarry {

class Claims {
 public:
  // Makes all claims void.
  void begin_round(std::size_t vertices) {
    words_.resize(vertices, ~std::uint64_t{0});
    ++round_;
  }

  // Each word may be read and written by many threads at once. All accesses are relaxed: what orders the
  // writes of the claiming loop before the reads of the deciding loop is the join between the two loops.
  // Every word is claimed even after one is lost: stopping early would make who blocks whom a matter of
  // timing.
  void claim(std::span<const VertexId> vertices, std::uint32_t rank) {
    const std::uint64_t mine = word(rank);
    for (const VertexId v : vertices) {
      std::atomic_ref<std::uint64_t> claimed(words_[v.value()]);
      std::uint64_t seen = claimed.load(std::memory_order_relaxed);
      while (mine < seen && !claimed.compare_exchange_weak(seen, mine, std::memory_order_relaxed)) {
      }
    }
  }

  [[nodiscard]] bool holds_all(std::span<const VertexId> vertices, std::uint32_t rank) {
    const std::uint64_t mine = word(rank);
    for (const VertexId v : vertices)
      if (std::atomic_ref<std::uint64_t>(words_[v.value()]).load(std::memory_order_relaxed) != mine)
        return false;
    return true;
  }

 private:
  [[nodiscard]] std::uint64_t word(std::uint32_t rank) const { return (std::uint64_t{~round_} << 32) | rank; }
  std::vector<std::uint64_t> words_;
  std::uint32_t round_ = 0;
};

// The rank of the item at a position of the window in a round. A bijection for each round: there are no ties,
// and the smallest rank of a round wins, so that every round advances. Rank equal to the position would let
// one item of each chain of neighbours win a round.
std::uint32_t rank_of(std::uint32_t position, std::uint32_t round);

}  // namespace quarry
