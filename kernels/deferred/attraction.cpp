#include "kernels/deferred/attraction.hpp"

namespace quarry::deferred {

AttractionMeter::AttractionMeter(const Mesh& mesh, VertexId v) : vertex_(v) {
  link_.gather(mesh, v);
  before_ = star_quality(link_, mesh.point(v));
}

Attraction AttractionMeter::to(Vec2 p) const {
  Attraction result;
  const double after = star_quality(link_, p);
  if (after <= 0) return result;
  result.vertex = vertex_;
  result.target = p;
  result.after = after;
  result.before = before_;
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
