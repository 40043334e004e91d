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

void Link::gather(const Mesh& mesh, VertexId v) {
  points_.clear();
  for_each_link_vertex(mesh, v, [&](VertexId u) { points_.push_back(mesh.point(u)); });
  closed_ = !points_.empty() && !mesh.on_boundary(v);
  if (closed_) points_.push_back(points_.front());
}

double star_quality(const Link& link, Vec2 p, double enough) {
  double worst = 1;
  const std::span<const Vec2> points = link.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double measure = lo_measure(p, points[i - 1], points[i]);
    if (!(measure > kSurelyPositive) && !(orient2d(p, points[i - 1], points[i]) > 0)) return -1;
    if (measure < enough) return measure;
    worst = std::min(worst, measure);
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
