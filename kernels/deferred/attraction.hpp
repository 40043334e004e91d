// Moving a vertex to a place that must become one: how much it costs, and whether it may (Araujo & Celes
// 2014, eqs. 3 to 6).
#pragma once

#include "engine/mesh/mesh.hpp"
#include "kernels/deferred/state.hpp"
#include "kernels/local/star.hpp"

namespace quarry::deferred {

struct Attraction {
  VertexId vertex;  // none: no candidate can move there at all
  Vec2 target;
  double before = 0;  // worst Lo measure of the star now
  double after = -1;  // and with the vertex at the target
  [[nodiscard]] double distortion() const { return (before - after) / before; }
  [[nodiscard]] bool better_than(const Attraction& other) const {
    return vertex.valid() && (!other.vertex.valid() || distortion() < other.distortion());
  }
};

// Measures attractions of one vertex.
class AttractionMeter {
 public:
  AttractionMeter(const Mesh& mesh, VertexId v);
  // The attraction to p, with vertex none if it would invert a triangle.
  [[nodiscard]] Attraction to(Vec2 p) const;

 private:
  VertexId vertex_;
  Link link_;
  double before_;
};

// True if the attraction keeps to both limits.
[[nodiscard]] bool acceptable(const Attraction& attraction, double quality_limit, double distortion_limit);

// True if the attraction is better than a forced split: it leaves a star that is worth something, or hardly
// changes it.
[[nodiscard]] bool tolerable(const Attraction& attraction);

}  // namespace quarry::deferred
