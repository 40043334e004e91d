// What the search for patches asks about vertices, in one compact array beside the mesh: faces around each,
// how many there should be, and whether the vertex may vanish. Kept up to date by whoever commits a patch.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/irregular_price.hpp"
#include "kernels/cleanup/node_slots.hpp"

namespace quarry {

class PatchStars {
 public:
  // The mesh has the vertex tag "ideal_faces" and ConstraintTags, and is cut open along constraints, or sewn
  // again with the nodes that find_regular_nodes finds with these slots. price may be empty: all places
  // cost 1.
  PatchStars(const Mesh& mesh, IrregularPrice price, const NodeSlots* slots = nullptr);

  // Makes room for vertices to come.
  void grow(std::size_t vertices) { stars_.resize(vertices); }
  // Counts the faces of v anew. Called for different vertices by many threads at once.
  void update(const Mesh& mesh, VertexId v);

  [[nodiscard]] int faces(VertexId v) const { return stars_[v.value()].faces; }
  [[nodiscard]] int ideal(VertexId v) const { return stars_[v.value()].ideal; }
  [[nodiscard]] bool on_boundary(VertexId v) const { return (stars_[v.value()].flags & kBoundary) != 0; }
  // Inside, but bound to its place, and on no line that is sewn: no patch may swallow it.
  [[nodiscard]] bool pinned(VertexId v) const { return (stars_[v.value()].flags & kPinned) != 0; }
  // On a line that is not cut open on both sides of this vertex: it slides along it, or is a node that a
  // regular vertex can hold.
  [[nodiscard]] bool on_line(VertexId v) const { return (stars_[v.value()].flags & kLine) != 0; }
  // Inside and free to move.
  [[nodiscard]] bool movable(VertexId v) const {
    return (stars_[v.value()].flags & (kBoundary | kPinned | kLine)) == 0;
  }
  // A seed: a vertex with another number of faces than it should have, all of them quads.
  [[nodiscard]] bool irregular(VertexId v) const {
    const Star& star = stars_[v.value()];
    return star.faces != star.ideal && star.faces != 0 && (star.flags & kTriangle) == 0;
  }
  [[nodiscard]] const ConstraintTags& tags() const { return tags_; }
  // The lines around a vertex that is on_line().
  [[nodiscard]] NodeArms arms(const Mesh& mesh, VertexId v) const;
  [[nodiscard]] const PieceFinder& pieces() const { return slots_->pieces(); }
  [[nodiscard]] bool has_price() const { return static_cast<bool>(price_); }
  [[nodiscard]] double price_at(Vec3 p) const { return price_ ? price_(p) : 1.0; }
  // The energy of v, had it so many faces.
  [[nodiscard]] double energy(const Mesh& mesh, VertexId v, int faces) const;
  // The energy that it has: on lines that of the sectors between them, so that one face here and three there
  // do not count as four.
  [[nodiscard]] double energy(const Mesh& mesh, VertexId v) const;

 private:
  static constexpr std::uint8_t kBoundary = 1, kPinned = 2, kTriangle = 4, kLine = 8;
  struct Star {
    std::uint8_t faces = 0, ideal = 4, flags = 0;
  };

  std::vector<Star> stars_;
  Tag<VertexId, std::uint8_t> ideal_;
  ConstraintTags tags_;
  IrregularPrice price_;
  const NodeSlots* slots_;
};

}  // namespace quarry
