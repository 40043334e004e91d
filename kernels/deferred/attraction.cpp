#include "kernels/deferred/attraction.hpp"

#include "kernels/local/star.hpp"

namespace quarry::deferred {

Attraction measure_attraction(const Mesh& mesh, VertexId v, Vec2 p) {
  Attraction result;
  const double after = star_quality(mesh, v, p);
  if (after <= 0) return result;
  result.vertex = v;
  result.target = p;
  result.after = after;
  result.before = star_quality(mesh, v, mesh.point(v));
  return result;
}

bool acceptable(const Attraction& attraction, double quality_limit, double distortion_limit) {
  return attraction.vertex.valid() && attraction.after >= quality_limit &&
         attraction.distortion() <= distortion_limit;
}

bool tolerable(const Attraction& attraction) {
  if (!attraction.vertex.valid()) return false;
  return (attraction.after > 0.02 && attraction.after > 0.2 * attraction.before) ||
         attraction.after > 0.9 * attraction.before;
}

}  // namespace quarry::deferred
