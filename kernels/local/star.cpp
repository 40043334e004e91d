#include "kernels/local/star.hpp"

#include <algorithm>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {

double star_quality(const Mesh& mesh, VertexId v, Vec2 p) {
  double worst = 1;
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    const Vec2 a = mesh.point(mesh.target(s));
    const SideId back = mesh.previous(s);
    const Vec2 b = mesh.point(mesh.origin(back));
    if (!(orient2d(p, a, b) > 0)) return -1;
    worst = std::min(worst, lo_measure(p, a, b));
    s = mesh.neighbour(back);
    if (s == first) break;
  }
  return worst;
}

void claim_star(const Mesh& mesh, VertexId v, Cavity& cavity) {
  cavity.claim(v);
  for_each_link_vertex(mesh, v, [&](VertexId u) { cavity.claim(u); });
}

void claim_two_rings(const Mesh& mesh, VertexId v, Cavity& cavity) {
  cavity.claim(v);
  for_each_link_vertex(mesh, v, [&](VertexId u) { claim_star(mesh, u, cavity); });
}

}  // namespace quarry
