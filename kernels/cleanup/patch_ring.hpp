// The rim of a patch as a ring of vertices, each with the faces that it is to get inside, and what is done
// where one of them is to get three or more (a reflex corner of the domain, the tip of a dead-end line): a
// grid is cut off along the continuation of one of its two rim edges, until only corners and sides are left.
//
//   r is reflex, C1 and C2 are the next two corners: the grid r, C1, C2, q has `across` edges from r to C1
//   and `along` edges from C1 to C2, and a wall of `along` new edges from r to q. What is left has q for a
//   corner and one face less at r. The same the other way round is called mirrored.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace quarry {

struct PatchCut {
  std::uint32_t at = 0;  // place of r on the ring
  std::uint32_t across = 0, along = 0;
  bool mirrored = false;
};

struct PatchRing {
  std::vector<std::uint32_t> ids;     // counter-clockwise
  std::vector<std::uint8_t> targets;  // faces: 1 at a corner, 2 on a side, more at a reflex vertex

  [[nodiscard]] std::size_t size() const { return ids.size(); }
  // The place that is `steps` after `at`, or before it.
  [[nodiscard]] std::size_t place(const PatchCut& cut, std::size_t steps) const {
    return (cut.mirrored ? cut.at + size() - steps : cut.at + steps) % size();
  }
  // The vertices from one number of steps to another, both included.
  [[nodiscard]] std::vector<std::uint32_t> run(const PatchCut& cut, std::size_t from, std::size_t to) const;
};

// The grid that can be cut off at a reflex vertex on one of its sides; none if another reflex vertex is in
// the way, or the wall would end in a corner.
[[nodiscard]] std::optional<PatchCut> find_cut(const PatchRing& ring, std::uint32_t at, bool mirrored);

// What is left of the ring, in the memory of another one. The inner vertices of the wall get the numbers from
// `next` on, from r to q.
void cut_off(const PatchRing& ring, const PatchCut& cut, std::uint32_t next, PatchRing& left);

}  // namespace quarry
