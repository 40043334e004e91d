// The lines around a vertex, and the places that they take among the four edges of a regular vertex.
//
//   Where the angles between neighbouring lines are near to 1, 2, 3 or 4 right angles, and these add up to 4,
//   a regular vertex can hold them all: where two lines cross, one ends on another, one bends a little or by
//   a right angle, or has a dead end. Such a node is like any other inner vertex, but for its fixed place.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct NodeArms {
  static constexpr int kSlots = 4;
  std::array<SideId, kSlots> sides;        // along the lines, counter-clockwise
  std::array<std::uint8_t, kSlots> slots;  // right angles from the first of them, ascending
  int count = 0;

  // Faces that the sector after arm i is to have.
  [[nodiscard]] int ideal(int i) const { return (i + 1 < count ? slots[at(i + 1)] : kSlots) - slots[at(i)]; }
  // Whether they leave the vertex in opposite directions.
  [[nodiscard]] bool opposite(int i, int j) const { return (slots[at(i)] + slots[at(j)]) % 2 == 0 && i != j; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

// The lines around a vertex that slides, or a node, in one piece; none if no regular vertex can hold them.
// A mesh that is cut open along one of them begins and ends there.
[[nodiscard]] std::optional<NodeArms> arms_of(const Mesh& mesh, const ConstraintTags& tags, VertexId v);

// By vertex, whether it is an inner node that a regular vertex can hold, and may stay in one piece where the
// edges between two nodes one of which may not are cut open. Of a mesh that is not cut open.
[[nodiscard]] std::vector<std::uint8_t> find_regular_nodes(const Mesh& mesh, const ConstraintTags& tags);

}  // namespace quarry
