// What it costs to merge two triangles, by the shape of the quad that comes of it; as whole numbers, so that
// sums do not depend on their order.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/matching/join.hpp"

namespace quarry {

// The cost of a join: over its quads 1 - shape + low_weight * (shortfall below low_shape), and flat_weight
// more where the quad is not strictly convex; for each triangle that needs a Steiner point `steiner`; and for
// each vertex `valence` times the square of the number of faces too many or too few.
struct JoinCostOptions {
  double low_shape = 0.3;
  double low_weight = 4;
  double flat_shape = 0.05;
  double flat_weight = 20;
  double steiner = 2;
  double valence = 0.1;
};

// The shape (smallest corner sine) of the quad that each arc of the dual would make, for each side slot (four
// a face); kNoArc where there is no arc. In space as in the plane. In parallel.
[[nodiscard]] std::vector<float> pair_shapes(const Mesh& mesh, ConstraintTags tags);

// Costs are multiples of 1 / kCostUnit.
inline constexpr double kCostUnit = 2048;

// The cost of each merge in its four cases: either triangle whole, or cut in three around its centroid.
class MergeCosts {
 public:
  // shapes: as pair_shapes gives them.
  MergeCosts(const Mesh& mesh, const std::vector<float>& shapes, const JoinCostOptions& options);

  // own, other: whether the face of s and the one across are split.
  [[nodiscard]] int operator()(SideId s, bool own, bool other) const {
    return costs_[(3 * s.face().value() + static_cast<std::size_t>(s.index())) * 4 + (own ? 1U : 0U) +
                  (other ? 2U : 0U)];
  }
  [[nodiscard]] int steiner() const { return steiner_; }
  [[nodiscard]] int valence() const { return valence_; }

 private:
  std::vector<std::uint16_t> costs_;  // four a side, three sides a face
  int steiner_, valence_;
};

}  // namespace quarry
