// Measures of the star of a vertex in a triangle mesh, as it is or with the vertex elsewhere.
#pragma once

#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "engine/operation/cavity.hpp"

namespace quarry {

// The points around a vertex of a triangle mesh, counter-clockwise; if it lies inside, the first of them once
// more at the end: each with the next is the far side of a triangle. Keeps its memory from one to the next.
class Link {
 public:
  void gather(const Mesh& mesh, VertexId v);

  [[nodiscard]] std::span<const Vec2> points() const { return points_; }
  // The same, each once.
  [[nodiscard]] std::span<const Vec2> distinct() const {
    return std::span(points_).first(points_.size() - (closed_ ? 1 : 0));
  }

 private:
  std::vector<Vec2> points_;
  bool closed_ = false;
};

// Lo's measure of the worst triangle of a star, were its vertex at p: in (0, 1] if all triangles turn left
// (exact), else -1. Araujo & Celes 2014, eqs. (1) and (2). Below `enough` it is some value below it: who
// needs no more than that gets an answer sooner.
[[nodiscard]] double star_quality(const Link& link, Vec2 p, double enough = 0);

// Claims v and its link.
void claim_star(const Mesh& mesh, VertexId v, Cavity& cavity);
// Claims v, its link and the links of its link: what a guarded smoothing of the link reads.
void claim_two_rings(const Mesh& mesh, VertexId v, Cavity& cavity);

// Calls visit(VertexId) for each vertex joined to v, counter-clockwise.
template <class Visit>
void for_each_link_vertex(const Mesh& mesh, VertexId v, Visit&& visit) {
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    visit(mesh.target(s));
    const SideId back = mesh.previous(s);
    s = mesh.neighbour(back);
    if (!s.valid()) visit(mesh.origin(back));
    if (s == first) break;
  }
}

}  // namespace quarry
