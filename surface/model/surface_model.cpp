#include "surface/model/surface_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace quarry {
namespace {

// Points on edges for each square of their spacing, at most.
constexpr double kMostPoints = 4;

TriangleTree tree_of(const Mesh& mesh) {
  std::vector<Vec3> points;
  points.reserve(mesh.vertex_slots());
  for (const VertexId v : mesh.vertices()) points.push_back(mesh.point3(v));
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(mesh.face_slots());
  for (const FaceId f : mesh.faces())
    triangles.push_back({mesh.corner(f, 0).value(), mesh.corner(f, 1).value(), mesh.corner(f, 2).value()});
  return TriangleTree(points, triangles);
}

}  // namespace

SurfaceModel::SurfaceModel(const Mesh& triangles, const ConstraintTags& tags, double spacing)
    : tree_(tree_of(triangles)), normals_(corner_normals(triangles, tags)) {
  for (const VertexId v : triangles.vertices()) {
    if (!triangles.alive(v) || !tags.support[v].is_free()) continue;
    const SideId s = triangles.side_of(v);
    free_points_.push_back({triangles.point3(v),
                            normals_[s.face().value()][static_cast<std::size_t>(s.index())],
                            s.face().value()});
  }
  if (std::isfinite(spacing)) add_edge_points(triangles, tags, spacing);
}

void SurfaceModel::add_edge_points(const Mesh& triangles, const ConstraintTags& tags, double spacing) {
  double area = 0, sum = 0;
  std::vector<std::pair<SideId, double>> edges;
  for (const FaceId f : triangles.faces()) {
    const Vec3 a = triangles.point3(triangles.corner(f, 0));
    area += 0.5 * length(cross(triangles.point3(triangles.corner(f, 1)) - a,
                               triangles.point3(triangles.corner(f, 2)) - a));
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const SideId t = triangles.neighbour(s);
      if (!t.valid() || t < s || tags.constrained(s)) continue;
      const double size =
          length(triangles.point3(triangles.target(s)) - triangles.point3(triangles.origin(s)));
      if (!(size > spacing)) continue;
      sum += size;
      edges.emplace_back(s, size);
    }
  }
  if (!(area > 0)) return;
  const double step = std::max(spacing, sum * spacing * spacing / (kMostPoints * area));
  double next = 0.5 * step;  // along the edge at hand
  for (const auto& [s, size] : edges) {
    for (; next < size; next += step) {
      const double share = next / size;
      SurfacePoint p;
      p.triangle = TriangleId(s.face().value());
      p.weights[static_cast<std::size_t>(s.index())] = 1 - share;
      p.weights[static_cast<std::size_t>((s.index() + 1) % 3)] = share;
      p.position =
          (1 - share) * triangles.point3(triangles.origin(s)) + share * triangles.point3(triangles.target(s));
      free_points_.push_back(with_normal(p));
    }
    next -= size;
  }
}

SurfacePoint SurfaceModel::nearest(const SpacePoint& p) const {
  const double size = length(p.up);
  ClosestQuery query;
  if (p.found_at != SpacePoint::kNowhere) query.start = TriangleId(p.found_at);
  if (!(size > 0)) return tree_.closest(p.place, query);
  query.normal = (1 / size) * p.up;
  query.least_cosine = kSameSide;
  const SurfacePoint found = tree_.closest(p.place, query);
  return found.triangle.valid() ? found : tree_.closest(p.place);
}

SpacePoint SurfaceModel::with_normal(const SurfacePoint& p) const {
  const CornerNormals& normals = normals_[p.triangle.value()];
  const CornerWeights& w = p.weights;
  const Vec3 sum = w[0] * normals[0] + w[1] * normals[1] + w[2] * normals[2];
  const double size = length(sum);
  return {p.position, size > 0 ? (1 / size) * sum : normals[0], p.triangle.value()};
}

SpacePoint SurfaceModel::project(const SpacePoint& p) const { return with_normal(nearest(p)); }

bool SurfaceModel::faces_along(Vec3 place, Vec3 direction, double slack, double reach) const {
  const double size = length(direction);
  if (!(size > 0)) return false;
  ClosestQuery query;
  query.normal = (1 / size) * direction;
  query.least_cosine = 0;
  // Whatever lies nearest: so near is near enough, and one search does.
  query.radius = std::min(slack, reach);
  if (tree_.closest(place, query).triangle.valid()) return true;
  const double squared = tree_.closest(place).squared_distance;
  query.radius = std::min(std::sqrt(squared) + slack, std::sqrt(squared + reach * reach));
  return tree_.closest(place, query).triangle.valid();
}

}  // namespace quarry
