#include "kernels/matching/merge_cost.hpp"

#include <algorithm>
#include <cmath>

#include "engine/parallel/parallel.hpp"
#include "kernels/matching/quad_shape.hpp"
#include "kernels/matching/spanning_forest.hpp"

namespace quarry {
namespace {

int in_units(double cost) { return static_cast<int>(std::lround(cost * kCostUnit)); }

std::uint16_t cost_of(double shape, const JoinCostOptions& options) {
  double cost = 1 - shape + options.low_weight * std::max(0.0, options.low_shape - shape);
  if (shape <= options.flat_shape) cost += options.flat_weight;
  return static_cast<std::uint16_t>(std::clamp(in_units(cost), 0, 65535));
}

// The corners of an edge's quad: its ends, and on either side the apex or the centroid of the triangle.
template <class Point>
struct EdgeQuad {
  Point from, to, left, right;

  [[nodiscard]] double shape(bool split_left, bool split_right) const {
    const Point l = split_left ? matching::centroid(from, to, left) : left;
    const Point r = split_right ? matching::centroid(to, from, right) : right;
    return matching::quad_shape(from, r, to, l);
  }
};

template <class Point>
EdgeQuad<Point> quad_of(const Mesh& mesh, SideId s) {
  return {point_of<Point>(mesh, mesh.origin(s)), point_of<Point>(mesh, mesh.target(s)),
          point_of<Point>(mesh, matching::apex(mesh, s)),
          point_of<Point>(mesh, matching::apex(mesh, mesh.neighbour(s)))};
}

}  // namespace

std::vector<float> pair_shapes(const Mesh& mesh, ConstraintTags tags) {
  std::vector<float> shapes(4 * mesh.face_slots(), kNoArc);
  matching::with_points_of(mesh, [&]<class Point>(Point) {
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      if (!mesh.alive(f)) return;
      for (int k = 0; k < 3; ++k) {
        const SideId s(f, k);
        const SideId t = mesh.neighbour(s);
        if (!matching::joinable(mesh, tags, s) || t < s) continue;
        const auto shape = static_cast<float>(quad_of<Point>(mesh, s).shape(false, false));
        shapes[s.value()] = shape;
        shapes[t.value()] = shape;
      }
    });
  });
  return shapes;
}

MergeCosts::MergeCosts(const Mesh& mesh, const std::vector<float>& shapes, const JoinCostOptions& options)
    : costs_(12 * mesh.face_slots()),
      steiner_(in_units(options.steiner)),
      valence_(in_units(options.valence)) {
  const auto place_of = [](SideId s) {
    return 4 * (3 * std::size_t{s.face().value()} + static_cast<std::size_t>(s.index()));
  };
  matching::with_points_of(mesh, [&]<class Point>(Point) {
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      for (int k = 0; k < 3; ++k) {
        const SideId s(FaceId(i), k);
        const SideId t = mesh.neighbour(s);
        if (shapes[s.value()] <= kNoArc || t < s) continue;
        const auto quad = quad_of<Point>(mesh, s);
        std::uint16_t* own = &costs_[place_of(s)];
        std::uint16_t* other = &costs_[place_of(t)];
        own[0] = other[0] = cost_of(shapes[s.value()], options);
        own[1] = other[2] = cost_of(quad.shape(true, false), options);
        own[2] = other[1] = cost_of(quad.shape(false, true), options);
        own[3] = other[3] = cost_of(quad.shape(true, true), options);
      }
    });
  });
}

}  // namespace quarry
