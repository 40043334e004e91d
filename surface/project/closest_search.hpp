// The search for the triangle that is nearest to one point.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "surface/project/triangle_blocks.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry {

class ClosestSearch {
 public:
  // Both outlive the search.
  ClosestSearch(const TriangleBlocks& triangles, Vec3 p, const ClosestQuery& query)
      : triangles_(triangles),
        query_(query),
        p_(p),
        local_(triangles.frame().local(p)),
        slack_(FloatFrame::slack(local_)),
        radius_(triangles.frame().covering_radius(query.radius, slack_)),
        squared_(query.radius * query.radius) {}

  [[nodiscard]] SurfacePoint run() {
    if (query_.start.valid()) {
      const auto [block, lane] = triangles_.slot_of(query_.start);
      offer(triangles_.block(block), block, lane, triangles_.block(block).squared_distances(p_)[lane]);
    }
    triangles_.tree().visit_near(FloatFrame::rounded(local_), radius_,
                                 [&](std::uint32_t block) { return visit(block); });
    return result();
  }

 private:
  float visit(std::uint32_t number) {
    const TriangleBlock& block = triangles_.block(number);
    const Double2 squared = block.squared_distances(p_);
    for (std::uint32_t lane = 0; lane < BoxTree::kBlockSize; ++lane)
      if (squared[lane] <= squared_) offer(block, number, lane, squared[lane]);
    return radius_;
  }

  // While there is no triangle yet, its number counts as higher than any: the radius is within the radius.
  void offer(const TriangleBlock& block, std::uint32_t block_number, std::uint32_t lane, double squared) {
    const TriangleId number = block.numbers[lane];
    if (squared > squared_ || (squared == squared_ && !(number < number_))) return;
    if (!number.valid() || !qualifies(block, lane)) return;
    squared_ = squared;
    number_ = number;
    slot_ = {block_number, lane};
    radius_ = std::min(radius_, triangles_.frame().covering_radius(std::sqrt(squared), slack_));
  }

  [[nodiscard]] bool qualifies(const TriangleBlock& block, std::uint32_t lane) const {
    if (query_.least_cosine > -1 &&
        !(dot(block.triangle(lane).unit_normal(), query_.normal) >= query_.least_cosine))
      return false;
    return query_.keep(block.numbers[lane]);
  }

  [[nodiscard]] SurfacePoint result() const {
    if (!number_.valid()) return {};
    const OrderedTriangle triangle = triangles_.block(slot_.block).triangle(slot_.lane);
    const CornerWeights weights = closest_on_triangle(p_, triangle.corners).weights;
    return {point_at(weights, triangle.corners), number_, triangle.as_given(weights), squared_};
  }

  const TriangleBlocks& triangles_;
  const ClosestQuery& query_;
  const Vec3 p_, local_;
  const double slack_;
  float radius_;
  double squared_;  // of the best triangle so far, or of the radius
  TriangleId number_;
  TriangleBlocks::Slot slot_;
};

}  // namespace quarry
