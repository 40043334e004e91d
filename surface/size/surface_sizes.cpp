#include "surface/size/surface_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// The shortest way from what is limited to each vertex (Dijkstra), with distances times the growth.
void limit_growth(const Mesh& mesh, double growth, std::vector<double>& most) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < most.size(); ++v)
    if (std::isfinite(most[v])) queue.push({most[v], v});
  while (!queue.empty()) {
    const auto [size, i] = queue.top();
    queue.pop();
    if (size > most[i]) continue;
    const Vec3 here = mesh.point3(VertexId(i));
    const auto offer = [&](VertexId w) {
      const double there = size + growth * length(mesh.point3(w) - here);
      if (!(there < most[w.value()])) return;
      most[w.value()] = there;
      queue.push({there, w.value()});
    };
    for_each_side_around(mesh, VertexId(i), [&](SideId s) {
      offer(mesh.target(s));
      offer(mesh.origin(mesh.previous(s)));
    });
  }
}

}  // namespace

SurfaceSizes::SurfaceSizes(const Mesh& triangles, std::vector<double> most, double growth, double edge,
                           std::vector<TightPlace> tight)
    : edge_(edge), growth_(growth), tight_(std::move(tight)) {
  if (tight_.empty() && std::none_of(most.begin(), most.end(), [&](double size) { return size < edge; }))
    return;
  limit_growth(triangles, growth, most);
  most_ = std::move(most);
  points_.reserve(triangles.vertex_slots());
  for (const VertexId v : triangles.vertices()) points_.push_back(triangles.point3(v));
  triangles_.reserve(triangles.face_slots());
  for (const FaceId f : triangles.faces())
    triangles_.push_back(
        {triangles.corner(f, 0).value(), triangles.corner(f, 1).value(), triangles.corner(f, 2).value()});
}

double SurfaceSizes::at(const SurfacePoint& p) const {
  if (uniform()) return edge_;
  double size = tightest(p.position);
  for (const std::uint32_t corner : triangles_[p.triangle.value()])
    size = std::min(size, leniency_ * most_[corner] + growth_ * length(p.position - points_[corner]));
  return size;
}

double SurfaceSizes::at(VertexId v) const { return uniform() ? edge_ : at_point(v.value()); }

double SurfaceSizes::tightest(Vec3 place) const {
  double size = edge_;
  for (const TightPlace& tight : tight_)
    size = std::min(size, tight.edge + growth_ * length(place - tight.place));
  return size;
}

double SurfaceSizes::area_of(std::size_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return 0.5 * length(cross(points_[b] - points_[a], points_[c] - points_[a]));
}

SurfaceSizes::Limited SurfaceSizes::limited() const {
  Limited result{.smallest = edge_, .place = {}};
  double all = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const double area = area_of(i);
    all += area;
    for (const std::uint32_t corner : triangles_[i]) {
      const double size = at_point(corner);
      if (size < edge_) result.share += area / 3;
      if (size < result.smallest) result.place = points_[corner];
      result.smallest = std::min(result.smallest, size);
    }
  }
  if (all > 0) result.share /= all;
  return result;
}

double SurfaceSizes::squares() const {
  return parallel::reduce_ordered(
      triangles_.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          double inverse = 0;
          for (const std::uint32_t corner : triangles_[i]) {
            const double size = at_point(corner);
            inverse += 1 / (3 * size * size);
          }
          sum += area_of(i) * inverse;
        }
        return sum;
      },
      [](double a, double b) { return a + b; });
}

}  // namespace quarry
