#include "surface/project/triangle_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "surface/project/closest_search.hpp"
#include "surface/project/local_ray.hpp"
#include "surface/project/ray_crossing.hpp"
#include "surface/project/triangle_blocks.hpp"

namespace quarry {
namespace {

// Queries that follow each other on the curve, each starting from the answer of the one before.
constexpr std::size_t kQueryChunk = 256;
// Bits of the key along the curve that are sorted by: 256 cells a side, three passes of the sort.
constexpr unsigned kOrderBits = 24;

std::vector<std::uint32_t> order_of_visits(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3 p : points) box.extend(p);
  std::vector<std::uint64_t> keys(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) {
    keys[i] = hilbert_key(points[i], box) >> (3 * kHilbertOrder3 - kOrderBits);
  });
  return parallel::sorted_order(std::move(keys));
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Vec3> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles,
                           const std::string& instruction_set)
    : triangles_(std::make_unique<const TriangleBlocks>(points, triangles, instruction_set)) {}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

SurfacePoint TriangleTree::closest(Vec3 p, const ClosestQuery& query) const {
  return ClosestSearch(*triangles_, p, query).run();
}

std::vector<SurfacePoint> TriangleTree::closest_all(std::span<const Vec3> points, const ClosestQuery& query,
                                                    std::span<const Vec3> normals) const {
  const std::vector<std::uint32_t> order = order_of_visits(points);
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
  const LocalRay local(triangles_->box(), triangles_->frame(), origin, direction);
  if (local.misses()) return {};
  const ShearedRay sheared(origin, direction);
  float length = local.length();
  SurfaceHit best{.parameter = std::numeric_limits<double>::infinity()};
  triangles_->tree().visit_along(local.origin(), local.direction(), length, [&](std::uint32_t number) {
    const TriangleBlock& block = triangles_->block(number);
    for (std::size_t lane = 0; lane < BoxTree::kBlockSize && block.numbers[lane].valid(); ++lane) {
      const OrderedTriangle triangle = block.triangle(lane);
      const auto touched = sheared.touch(triangle.corners);
      if (!touched || touched->parameter < 0 || touched->parameter > best.parameter) continue;
      if (touched->parameter == best.parameter && !(block.numbers[lane] < best.triangle)) continue;
      best = {touched->parameter, point_at(touched->weights, triangle.corners), block.numbers[lane],
              triangle.as_given(touched->weights)};
      length = std::min(length, local.length_to(best.parameter));
    }
    return length;
  });
  return best.triangle.valid() ? best : SurfaceHit();
}

CrossingCounts TriangleTree::crossings(Vec3 origin, Vec3 direction) const {
  const LocalRay local(triangles_->box(), triangles_->frame(), origin, direction);
  CrossingCounts counts;
  if (local.misses()) return counts;
  const ShearedRay sheared(origin, direction);
  const float length = local.length();
  triangles_->tree().visit_along(local.origin(), local.direction(), length, [&](std::uint32_t number) {
    const TriangleBlock& block = triangles_->block(number);
    for (std::size_t lane = 0; lane < BoxTree::kBlockSize && block.numbers[lane].valid(); ++lane) {
      const OrderedTriangle triangle = block.triangle(lane);
      const auto crossed = sheared.cross(triangle.corners);
      if (!crossed || crossed->parameter < 0) continue;
      ++(crossed->from_front != triangle.mirrored() ? counts.from_front : counts.from_back);
    }
    return length;
  });
  return counts;
}

bool TriangleTree::encloses(Vec3 p) const {
  const CrossingCounts counts = crossings(p, {0, 0, 1});
  return (counts.from_front + counts.from_back) % 2 == 1;
}

}  // namespace quarry
