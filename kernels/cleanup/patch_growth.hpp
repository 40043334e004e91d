// Grows a patch of quads until it is topologically convex, at a price proportional to the faces added: three
// counters tell all that is asked after each step (Bunin 2006, with the outer angle of a rim vertex taken
// from the faces that it keeps outside).
//
//   outer angle of a rim vertex   t = 2 + faces outside - ideal: 0 on a side, 1 at a corner, negative where
//   the
//                                 patch is concave and takes in all faces of the vertex.
//   pinch                         a vertex with more than two rim edges
//   disk                          vertices - edges + faces = 1 without a pinch
// A boundary vertex that wants three faces or more (a reflex corner, the tip of a dead-end line) is concave
// with nothing left to take in: it counts as a side. Triangles and pinned vertices stop the growth.
// Where lines are not cut open, the patch takes in faces until each line enters it across from the last two
// faces outside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/node_slots.hpp"
#include "kernels/cleanup/patch_stars.hpp"
#include "kernels/local/paged_array.hpp"

namespace quarry {

class PatchGrowth {
 public:
  // Starts with no face. largest: faces that the patch may have. The mesh and its stars must not change until
  // the next call. Keeps its memory.
  void begin(const Mesh& mesh, const PatchStars& stars, std::size_t largest);

  // Takes in all faces around v. False once the patch is too large or meets what it may not swallow; it is of
  // no use then.
  bool add_star(VertexId v);
  // Takes in the face across an edge of the patch, from a to b on its rim. False as above; true if there is
  // none.
  bool add_across(VertexId a, VertexId b);
  // Takes in the faces around concave vertices and pinches until there are none. False as above.
  bool make_convex();

  // The vertices on the rim, in the order in which they were met.
  std::span<const VertexId> rim_vertices();
  [[nodiscard]] bool is_disk() const {
    return vertices_ - edges_ + static_cast<std::int64_t>(faces_.size()) == 1;
  }
  // The rim of a disk, counter-clockwise from its vertex of smallest number.
  void walk_rim(std::vector<VertexId>& rim);

  [[nodiscard]] std::span<const FaceId> faces() const { return faces_; }
  // All vertices of the patch, in the order in which they were met.
  [[nodiscard]] std::span<const VertexId> vertices() const { return members_; }
  [[nodiscard]] bool contains(FaceId f) const { return taken_.get(f); }
  // Whether the edge lies inside.
  [[nodiscard]] bool holds_both_sides(SideId s) const {
    const SideId across = mesh_->neighbour(s);
    return contains(s.face()) && across.valid() && contains(across.face());
  }
  [[nodiscard]] bool contains(VertexId v) const { return counts_.get(v).faces != 0; }
  // Faces of the patch around a vertex of it.
  [[nodiscard]] int inside(VertexId v) const { return counts_.get(v).faces; }
  [[nodiscard]] int outside(VertexId v) const { return stars_->faces(v) - inside(v); }
  [[nodiscard]] int outer_angle(VertexId v) const { return 2 + outside(v) - stars_->ideal(v); }
  [[nodiscard]] bool on_rim(VertexId v) const { return counts_.get(v).rim_edges != 0; }
  // Sum of ideal - faces over the patch: with every outer angle met, the patch has 4 - this sides.
  [[nodiscard]] int charge() const { return charge_; }
  // Faces beyond two that boundary vertices are to have, of those that keep none outside. It never falls.
  [[nodiscard]] int reflex() const { return reflex_; }
  // Valence energy of the patch, rim included.
  [[nodiscard]] double energy() const { return energy_; }
  [[nodiscard]] VertexId smallest_irregular() const;

 private:
  struct Counts {
    std::uint16_t faces = 0, rim_edges = 0;
  };

  bool add_face(FaceId f);
  void meet(VertexId v);
  bool settle(VertexId v);
  bool settle_line(VertexId v);
  // Whether of the lines around a rim vertex the one that does not enter and lies across is outside, and no
  // other.
  [[nodiscard]] bool goes_on_across(const NodeArms& arms, int entering) const;

  const Mesh* mesh_ = nullptr;
  const PatchStars* stars_ = nullptr;
  std::size_t largest_ = 0;
  std::int64_t vertices_ = 0, edges_ = 0;
  int charge_ = 0, reflex_ = 0;
  double energy_ = 0;
  PagedArray<FaceId, bool> taken_;
  PagedArray<VertexId, Counts> counts_;  // no face: not met
  std::vector<FaceId> faces_;
  std::vector<VertexId> members_;
  std::vector<VertexId> rim_;   // holds all rim vertices, and some that lie inside by now
  std::vector<VertexId> work_;  // vertices whose counters have changed
};

}  // namespace quarry
