#include "surface/model/surface_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quarry {
namespace {

// The cosine of 80 degrees: a wall's other side turns by 180.
constexpr double kSameSide = 0.17;

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

SurfaceModel::SurfaceModel(const Mesh& triangles, const ConstraintTags& tags)
    : tree_(tree_of(triangles)), normals_(corner_normals(triangles, tags)) {
  for (const VertexId v : triangles.vertices()) {
    if (!triangles.alive(v) || !tags.support[v].is_free()) continue;
    const SideId s = triangles.side_of(v);
    free_points_.push_back({triangles.point3(v),
                            normals_[s.face().value()][static_cast<std::size_t>(s.index())],
                            s.face().value()});
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
  const double squared = tree_.closest(place).squared_distance;
  query.radius = std::min(std::sqrt(squared) + slack, std::sqrt(squared + reach * reach));
  return tree_.closest(place, query).triangle.valid();
}

}  // namespace quarry
