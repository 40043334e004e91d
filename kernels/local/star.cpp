#include "kernels/local/star.hpp"

#include <algorithm>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

// A triangle with a larger measure is counter-clockwise for certain: coordinate differences are rounded once,
// so that the error of the doubled area is within a few units in the last place of the squared edges.
constexpr double kSurelyPositive = 1e-12;

}  // namespace

double star_quality(const Mesh& mesh, VertexId v, Vec2 p, double enough) {
  double worst = 1;
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    const Vec2 a = mesh.point(mesh.target(s));
    const SideId back = mesh.previous(s);
    const Vec2 b = mesh.point(mesh.origin(back));
    const double measure = lo_measure(p, a, b);
    if (!(measure > kSurelyPositive) && !(orient2d(p, a, b) > 0)) return -1;
    if (measure < enough) return measure;
    worst = std::min(worst, measure);
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
