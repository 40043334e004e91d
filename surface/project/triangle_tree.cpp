#include "surface/project/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "surface/project/box_tree.hpp"
#include "surface/project/local_ray.hpp"
#include "surface/project/packed_triangles.hpp"
#include "surface/project/ray_crossing.hpp"

namespace quarry {
namespace {

// Queries that follow each other on the curve, each starting from the answer of the one before.
constexpr std::size_t kQueryChunk = 256;

// The best triangle so far, and how far from the point one that is better can be.
class ClosestSearch {
 public:
  ClosestSearch(const PackedTriangles& triangles, Vec3 p, const ClosestQuery& query)
      : triangles_(triangles), p_(p), query_(query), local_(triangles.frame().local(p)) {
    const double farthest = std::max({std::abs(local_.x), std::abs(local_.y), std::abs(local_.z)});
    slack_ = FloatFrame::kSlack * (1 + farthest);
    best_.squared_distance = query.radius * query.radius;
    radius_ = triangles.frame().covering_radius(query.radius, slack_);
    if (query.start.valid()) offer(triangles.slot_of(query.start));
  }

  [[nodiscard]] FloatPoint center() const { return FloatFrame::rounded(local_); }
  [[nodiscard]] float radius() const { return radius_; }

  // The radius from then on.
  float offer(std::uint32_t slot) {
    const PackedTriangle& triangle = triangles_[slot];
    const TrianglePoint point = closest_on_triangle(p_, triangle.corners);
    if (point.squared_distance > best_.squared_distance) return radius_;
    // No triangle yet counts as the highest number: the radius itself is within the radius.
    if (point.squared_distance == best_.squared_distance && !(triangle.number < number_)) return radius_;
    if (!qualifies(slot)) return radius_;
    best_ = point;
    number_ = triangle.number;
    slot_ = slot;
    radius_ =
        std::min(radius_, triangles_.frame().covering_radius(std::sqrt(point.squared_distance), slack_));
    return radius_;
  }

  [[nodiscard]] SurfacePoint result() const {
    if (!number_.valid()) return {};
    const PackedTriangle& triangle = triangles_[slot_];
    return {point_at(best_.weights, triangle.corners), number_, weights_as_given(triangle, best_.weights),
            best_.squared_distance};
  }

 private:
  [[nodiscard]] bool qualifies(std::uint32_t slot) const {
    if (query_.least_cosine > -1 &&
        !(dot(triangles_.unit_normal(slot), query_.normal) >= query_.least_cosine))
      return false;
    return query_.keep(triangles_[slot].number);
  }

  const PackedTriangles& triangles_;
  Vec3 p_;
  const ClosestQuery& query_;
  Vec3 local_;
  double slack_ = 0;
  float radius_ = 0;
  TrianglePoint best_;
  TriangleId number_;
  std::uint32_t slot_ = 0;
};

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3 p : points) box.extend(p);
  return box;
}

std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points) {
  const Box3 box = box_of(points);
  std::vector<std::uint64_t> keys(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) { keys[i] = hilbert_key(points[i], box); });
  return parallel::sorted_order(std::move(keys));
}

}  // namespace

struct TriangleTree::Parts {
  PackedTriangles triangles;
  BoxTree boxes;
};

TriangleTree::TriangleTree(std::span<const Vec3> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles,
                           const std::string& instruction_set) {
  PackedTriangles packed(points, triangles);
  BoxTree boxes(packed.float_boxes(), instruction_set);
  parts_ = std::make_unique<const Parts>(Parts{std::move(packed), std::move(boxes)});
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

SurfacePoint TriangleTree::closest(Vec3 p, const ClosestQuery& query) const {
  ClosestSearch search(parts_->triangles, p, query);
  parts_->boxes.visit_near(search.center(), search.radius(),
                           [&](std::uint32_t slot) { return search.offer(slot); });
  return search.result();
}

std::vector<SurfacePoint> TriangleTree::closest_all(std::span<const Vec3> points, const ClosestQuery& query,
                                                    std::span<const Vec3> normals) const {
  const std::vector<std::uint32_t> order = spatial_order(points);
  std::vector<SurfacePoint> results(points.size());
  parallel::for_each_chunk(order.size(), kQueryChunk, [&](std::size_t begin, std::size_t end) {
    ClosestQuery one = query;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t number = order[i];
      if (!normals.empty()) one.normal = normals[number];
      results[number] = closest(points[number], one);
      if (results[number].triangle.valid()) one.start = results[number].triangle;
    }
  });
  return results;
}

SurfaceHit TriangleTree::ray(Vec3 origin, Vec3 direction) const {
  const PackedTriangles& triangles = parts_->triangles;
  const LocalRay local(triangles, origin, direction);
  if (local.misses()) return {};
  const ShearedRay sheared(origin, direction);
  float length = local.length();
  SurfaceHit best;
  best.parameter = std::numeric_limits<double>::infinity();
  RayCrossing crossing;
  std::uint32_t found = 0;
  parts_->boxes.visit_along(local.origin(), local.direction(), length, [&](std::uint32_t slot) {
    const auto touched = sheared.touch(triangles[slot].corners);
    if (!touched || touched->parameter < 0 || touched->parameter > best.parameter) return length;
    const TriangleId number = triangles[slot].number;
    if (touched->parameter == best.parameter && !(number < best.triangle)) return length;
    best.parameter = touched->parameter;
    best.triangle = number;
    crossing = *touched;
    found = slot;
    length = std::min(length, local.length_to(best.parameter));
    return length;
  });
  if (!best.triangle.valid()) return {};
  best.position = point_at(crossing.weights, triangles[found].corners);
  best.weights = weights_as_given(triangles[found], crossing.weights);
  return best;
}

CrossingCounts TriangleTree::crossings(Vec3 origin, Vec3 direction) const {
  const PackedTriangles& triangles = parts_->triangles;
  const LocalRay local(triangles, origin, direction);
  CrossingCounts counts;
  if (local.misses()) return counts;
  const ShearedRay sheared(origin, direction);
  parts_->boxes.visit_along(local.origin(), local.direction(), local.length(), [&](std::uint32_t slot) {
    const PackedTriangle& triangle = triangles[slot];
    const auto crossed = sheared.cross(triangle.corners);
    if (crossed && crossed->parameter >= 0)
      ++(crossed->from_front != triangle.mirrored() ? counts.from_front : counts.from_back);
    return local.length();
  });
  return counts;
}

bool TriangleTree::encloses(Vec3 p) const {
  const CrossingCounts counts = crossings(p, {0, 0, 1});
  return (counts.from_front + counts.from_back) % 2 == 1;
}

}  // namespace quarry
