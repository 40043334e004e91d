// The chords of a quad mesh: the rows of faces that one crosses by leaving each by the side across from the
// one by which it was entered. A chord ends on the boundary, closes, or ends at a triangle.
//   J. Daniels, C. Silva, J. Shepherd, E. Cohen: Quadrilateral mesh simplification. ACM TOG 27(5), 2008.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct Chord {
  SideId first;             // by which its first face is entered
  std::uint32_t faces = 0;  // one that it crosses twice counts twice
  // Whether each of its rungs, the sides that it crosses, may become a point: none joins two fixed vertices,
  // or two vertices of lines past these lines. No chord that ends at a triangle can.
  bool collapsible = true;
  std::uint64_t signature = 0;  // names its faces
};

class Chords {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  // All chords, in the order of the first side of each. The mesh must be in one piece along its lines.
  Chords(const Mesh& mesh, const ConstraintTags& tags);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(chords_.size()); }
  [[nodiscard]] const Chord& operator[](std::uint32_t chord) const { return chords_[chord]; }
  // The chord that crosses a side of a face; none of a triangle.
  [[nodiscard]] std::uint32_t across(SideId s) const {
    return chord_of_[2 * s.face().value() + (s.value() & 1U)];
  }

  // Calls visit(SideId) for the side by which each face is entered.
  template <class Visit>
  void for_each_face(std::uint32_t chord, Visit&& visit) const {
    SideId s = chords_[chord].first;
    for (std::uint32_t i = 0; i < chords_[chord].faces; ++i) {
      visit(s);
      s = mesh_->neighbour(opposite(s));
    }
  }
  // Of a quad.
  [[nodiscard]] static SideId opposite(SideId s) { return SideId(s.value() ^ 2U); }

 private:
  void follow(SideId from, const ConstraintTags& tags);

  const Mesh* mesh_;
  std::vector<Chord> chords_;
  std::vector<std::uint32_t> chord_of_;  // by face: across its even sides and across its odd ones
};

// Whether a vertex is held by the boundary or a line.
[[nodiscard]] inline bool is_held(const Mesh& mesh, const ConstraintTags& tags, VertexId v) {
  return !tags.support[v].is_free() || mesh.on_boundary(v);
}

}  // namespace quarry
