// The dual graph of a triangle mesh, one node a triangle, and sets of its arcs: the spanning forest, and the
// join that says which triangles are merged. Two triangles that share an unconstrained edge have an arc.
#pragma once

#include <bit>
#include <cstdint>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// A set of dual arcs: bit k of a face is set if the arc across its side k is in the set. Both faces of an arc
// agree.
using DualArcs = IdVector<FaceId, std::uint8_t>;

namespace matching {

// True if the dual has an arc across s.
[[nodiscard]] inline bool joinable(const Mesh& mesh, ConstraintTags tags, SideId s) {
  return mesh.neighbour(s).valid() && !tags.constrained(s);
}

[[nodiscard]] inline bool contains(const DualArcs& arcs, SideId s) {
  return ((arcs[s.face()] >> s.index()) & 1U) != 0;
}
[[nodiscard]] constexpr std::uint8_t bit_of(int side) { return static_cast<std::uint8_t>(1U << side); }
[[nodiscard]] inline int degree(std::uint8_t bits) { return std::popcount(bits); }
// A triangle with three arcs in the join becomes three parts around a Steiner point.
[[nodiscard]] constexpr bool is_split(std::uint8_t bits) { return bits == 7; }

// The sides of a triangle without looking at its fourth corner.
[[nodiscard]] constexpr int next_of_three(int k) { return k == 2 ? 0 : k + 1; }
[[nodiscard]] constexpr int previous_of_three(int k) { return k == 0 ? 2 : k - 1; }
[[nodiscard]] inline VertexId apex(const Mesh& mesh, SideId s) {
  return mesh.corner(s.face(), previous_of_three(s.index()));
}

// One of the two sides of an edge.
[[nodiscard]] inline SideId canonical(const Mesh& mesh, SideId s) {
  const SideId t = mesh.neighbour(s);
  return t < s ? t : s;
}

// Makes both faces of each arc agree where one of them has it.
[[nodiscard]] DualArcs seen_from_both_faces(const Mesh& mesh, const DualArcs& arcs);

}  // namespace matching
}  // namespace quarry
