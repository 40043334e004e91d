// Directed edges in rings around their origins: the part of the quad-edge structure that a planar
// triangulation needs.
//   L. Guibas, J. Stolfi: Primitives for the manipulation of general subdivisions. ACM Trans. Graphics 4
//   (1985), section 9.
// Edges come from pools that can be joined, so that parts of a subdivision can be made at the same time and
// merged.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/id.hpp"

namespace quarry {

// A directed edge; an edge and its reverse differ in the last bit.
using RingEdgeId = Id<struct RingEdgeKind>;

// Edges not in use, in a chain.
struct EdgePool {
  RingEdgeId first;
  RingEdgeId last;
};

class EdgeRings {
 public:
  explicit EdgeRings(std::size_t edge_count) : records_(2 * edge_count) {}

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] bool used(RingEdgeId e) const { return records_[e].origin.valid(); }
  [[nodiscard]] static RingEdgeId reverse(RingEdgeId e) { return RingEdgeId(e.value() ^ 1U); }
  [[nodiscard]] VertexId origin(RingEdgeId e) const { return records_[e].origin; }
  [[nodiscard]] VertexId target(RingEdgeId e) const { return records_[reverse(e)].origin; }
  // The next edge from the same origin, counter-clockwise or clockwise.
  [[nodiscard]] RingEdgeId next(RingEdgeId e) const { return records_[e].next; }
  [[nodiscard]] RingEdgeId previous(RingEdgeId e) const { return records_[e].previous; }
  // The next edge around the face on the left.
  [[nodiscard]] RingEdgeId left_next(RingEdgeId e) const { return previous(reverse(e)); }
  // The previous edge around the face on the right.
  [[nodiscard]] RingEdgeId right_previous(RingEdgeId e) const { return next(reverse(e)); }

  // A pool of the edges begin <= i < end; no two pools may share one.
  EdgePool make_pool(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      records_[RingEdgeId(2 * i)].next = i + 1 < end ? RingEdgeId(2 * i + 2) : RingEdgeId();
    return {RingEdgeId(2 * begin), RingEdgeId(2 * end - 2)};
  }

  EdgePool join_pools(EdgePool a, EdgePool b) {
    if (!a.first.valid()) return b;
    if (!b.first.valid()) return a;
    records_[a.last].next = b.first;
    return {a.first, b.last};
  }

  // A new edge that is alone at both ends.
  RingEdgeId make_edge(VertexId from, VertexId to, EdgePool& pool) {
    const RingEdgeId e = pool.first;
    pool.first = records_[e].next;
    const RingEdgeId r = reverse(e);
    records_[e] = {from, e, e};
    records_[r] = {to, r, r};
    return e;
  }

  // Puts an edge that is alone at its origin behind another of the same origin.
  void insert_after(RingEdgeId place, RingEdgeId e) {
    const RingEdgeId behind = records_[place].next;
    records_[e].next = behind;
    records_[e].previous = place;
    records_[behind].previous = e;
    records_[place].next = e;
  }

  // A new edge from the target of a to the origin of b, such that all three have the same face on the left.
  RingEdgeId connect(RingEdgeId a, RingEdgeId b, EdgePool& pool) {
    const RingEdgeId place = left_next(a);
    const RingEdgeId e = make_edge(target(a), origin(b), pool);
    insert_after(place, e);
    insert_after(b, reverse(e));
    return e;
  }

  void delete_edge(RingEdgeId e, EdgePool& pool) {
    const RingEdgeId kept(e.value() & ~1U);
    for (const RingEdgeId side : {kept, reverse(kept)}) {
      const auto [origin, next, previous] = records_[side];
      records_[previous].next = next;
      records_[next].previous = previous;
      records_[side].origin = VertexId();
    }
    records_[kept].next = pool.first;
    if (!pool.first.valid()) pool.last = kept;
    pool.first = kept;
  }

 private:
  struct Record {
    VertexId origin;
    RingEdgeId next, previous;
  };
  IdVector<RingEdgeId, Record> records_;
};

}  // namespace quarry
