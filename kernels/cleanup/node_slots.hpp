// The places that the lines around a node take among the four edges of a regular vertex.
//
//   Where the angles between neighbouring lines, rounded to right angles, add up to four of them, a regular
//   vertex can hold the lines: where two cross, one ends on another, one bends a little or by a right angle,
//   or has a dead end. Such a node is like any other inner vertex, but for its fixed place. Slots are found
//   from the pieces and not from a mesh: nothing that happens to it changes them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The edges of a mesh that leave a vertex along lines, counter-clockwise.
class NodeArms {
 public:
  static constexpr int kSlots = 4;

  void add(SideId side, int slot) {
    sides_[static_cast<std::size_t>(count_)] = side;
    slots_[static_cast<std::size_t>(count_++)] = static_cast<std::uint8_t>(slot);
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] SideId side(int i) const { return sides_[static_cast<std::size_t>(i)]; }
  // Right angles from the first of them, rising.
  [[nodiscard]] int slot(int i) const { return slots_[static_cast<std::size_t>(i)]; }
  // Faces that the sector after arm i is to have.
  [[nodiscard]] int ideal(int i) const { return (i + 1 < count_ ? slot(i + 1) : kSlots) - slot(i); }
  // Whether they leave the vertex in opposite directions.
  [[nodiscard]] bool opposite(int i, int j) const { return i != j && (slot(i) + slot(j)) % 2 == 0; }

 private:
  std::array<SideId, kSlots> sides_;
  std::array<std::uint8_t, kSlots> slots_{};
  int count_ = 0;
};

class NodeSlots {
 public:
  // The lines must outlive it.
  explicit NodeSlots(const NodedLines& lines);

  // Whether a regular vertex can hold the lines at the node.
  [[nodiscard]] bool regular(NodeId node) const { return regular_[node.value()] != 0; }
  // The slot of a piece at one of its ends, which is regular: right angles counter-clockwise from another.
  [[nodiscard]] int slot(PieceId piece, NodeId end) const {
    return slots_[2 * piece.value() + (lines_->pieces[piece].to == end ? 1 : 0)];
  }
  [[nodiscard]] const PieceFinder& pieces() const { return pieces_; }

  // The arms of a vertex that slides, or is a regular node, in one piece and inside the domain; none of
  // others. A mesh that is cut open along one of them begins and ends there.
  [[nodiscard]] std::optional<NodeArms> arms_of(const Mesh& mesh, const ConstraintTags& tags,
                                                VertexId v) const;

 private:
  void find_slots(NodeId node);

  const NodedLines* lines_;
  PieceFinder pieces_;
  std::vector<std::uint8_t> regular_;  // by node
  std::vector<std::uint8_t> slots_;    // by piece, at its first end and its last
};

// By vertex, whether it is an inner node that is regular, and may stay in one piece where the edges between
// two nodes one of which may not are cut open. Of a mesh in the plane that is not cut open.
[[nodiscard]] std::vector<std::uint8_t> find_regular_nodes(const Mesh& mesh, const ConstraintTags& tags,
                                                           const NodeSlots& slots);

}  // namespace quarry
