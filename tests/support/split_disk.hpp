// The Delaunay triangulation of a disk with every triangle split in three quads: an all-quad mesh half of
// whose vertices are irregular.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/triangulation.hpp"

namespace quarry::test {

// Of radius 1 around the centre, with about so many quads. The mesh has ConstraintTags without constraints.
inline Mesh make_split_disk(double quads, std::uint64_t seed, Vec2 centre = {0, 0}) {
  // Three quads a triangle, whose area is sqrt(3) / 4 of the squared spacing.
  const double spacing = std::sqrt(3 * std::numbers::pi / quads * 4 / std::numbers::sqrt3);
  const Box2 box{{-1, -1}, {1, 1}};
  std::vector<Vec2> points;
  for (const Vec2 p : make_spaced_points(box, {.spacing = spacing, .jitter = 0.25, .seed = seed}))
    if (length(p) < 1 - 0.7 * spacing) points.push_back(centre + p);
  const auto around = std::llround(2 * std::numbers::pi / spacing);
  for (long long i = 0; i < around; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
    points.push_back(centre + Vec2{std::cos(turn), std::sin(turn)});
  }
  Mesh triangles = delaunay_triangulation(points);
  compact(triangles, EntityOrder::kHilbert);
  ConstraintTags::add_to(triangles);
  SubdivideReport report;
  return subdivide(std::move(triangles), {}, report, Progress());
}

}  // namespace quarry::test
