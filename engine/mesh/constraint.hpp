// How a mesh carries constraints while it is being made: each vertex knows what it is bound to, each face
// which of its sides lie on constraints. Two bytes a triangle; edges become entities only at the end.
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/geometry/pieces_around.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// What a vertex is bound to.
class Support {
 public:
  constexpr Support() = default;  // free: may move anywhere
  static constexpr Support free() { return Support(); }
  static constexpr Support fixed() { return Support(kFixed); }
  static constexpr Support at(NodeId node) { return Support(node.value() | kNodeBit); }
  static constexpr Support on(PieceId piece) { return Support(piece.value()); }

  [[nodiscard]] constexpr bool is_free() const { return value_ == kFree; }
  // Bound to a node, or to a place of its own (the hull of a start mesh): never moves.
  [[nodiscard]] constexpr bool is_fixed() const { return value_ != kFree && (value_ & kNodeBit) != 0; }
  [[nodiscard]] constexpr bool is_node() const { return is_fixed() && value_ != kFixed; }
  // Slides along a piece.
  [[nodiscard]] constexpr bool slides() const { return (value_ & kNodeBit) == 0; }
  [[nodiscard]] constexpr NodeId node() const {
    assert(is_node());
    return NodeId(value_ & ~kNodeBit);
  }
  [[nodiscard]] constexpr PieceId piece() const {
    assert(slides());
    return PieceId(value_);
  }
  friend constexpr bool operator==(Support, Support) = default;

 private:
  static constexpr std::uint32_t kNodeBit = 0x80000000U;
  static constexpr std::uint32_t kFree = 0xffffffffU;
  static constexpr std::uint32_t kFixed = 0xfffffffeU;
  constexpr explicit Support(std::uint32_t value) : value_(value) {}
  std::uint32_t value_ = kFree;
};

// The tags of a mesh under construction.
struct ConstraintTags {
  Tag<VertexId, Support> support;
  Tag<FaceId, std::uint8_t> sides;  // bit k: side k lies on a piece; both faces of an edge agree

  static ConstraintTags add_to(Mesh& mesh) {
    return {mesh.add_tag<VertexId, Support>("support"),
            mesh.add_tag<FaceId, std::uint8_t>("constrained_sides")};
  }
  static ConstraintTags of(const Mesh& mesh) {
    return {mesh.find_tag<VertexId, Support>("support"),
            mesh.find_tag<FaceId, std::uint8_t>("constrained_sides")};
  }

  [[nodiscard]] bool constrained(SideId s) const { return ((sides[s.face()] >> s.index()) & 1U) != 0; }
  void set_constrained(SideId s, bool value) {
    const auto bit = static_cast<std::uint8_t>(1U << s.index());
    auto& bits = sides[s.face()];
    bits = static_cast<std::uint8_t>(value ? bits | bit : bits & ~bit);
  }
};

// Calls visit(VertexId) for the other end of each constrained edge at v, counter-clockwise.
template <class Visit>
void for_each_constrained_neighbour(const Mesh& mesh, const ConstraintTags& tags, VertexId v, Visit&& visit) {
  for_each_side_around(mesh, v, [&](SideId s) {
    if (tags.constrained(s)) visit(mesh.target(s));
    // On the boundary the last edge comes in and has no twin that goes out.
    const SideId in = mesh.previous(s);
    if (!mesh.neighbour(in).valid() && tags.constrained(in)) visit(mesh.origin(in));
  });
}

// Finds the piece that joins two nodes; pieces are unique by their ends.
class PieceFinder {
 public:
  explicit PieceFinder(const NodedLines& lines) : lines_(&lines), around_(lines) {}

  // The piece between two nodes, or none.
  [[nodiscard]] PieceId between(NodeId a, NodeId b) const;
  // The pieces that end at a node, ascending.
  [[nodiscard]] std::span<const PieceId> at(NodeId node) const { return around_.at(node); }
  // The piece under a constrained edge whose ends have these supports. Two nodes: the piece between them.
  [[nodiscard]] PieceId under_edge(Support a, Support b) const {
    if (a.slides()) return a.piece();
    if (b.slides()) return b.piece();
    return between(a.node(), b.node());
  }

 private:
  const NodedLines* lines_;
  PiecesAround around_;
};

}  // namespace quarry
