// Measures of the star of a vertex in a triangle mesh, as it is or with the vertex elsewhere.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "engine/operation/cavity.hpp"

namespace quarry {

// Lo's measure of the worst triangle of the star of v, were v at p: in (0, 1] if all triangles turn left
// (exact), else -1. Araujo & Celes 2014, eqs. (1) and (2). Below `enough` it is some value below it: who needs
// no more than that gets an answer sooner.
[[nodiscard]] double star_quality(const Mesh& mesh, VertexId v, Vec2 p, double enough = 0);

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
