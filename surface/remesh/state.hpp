// What the operations of surface remeshing share.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/remesh/options.hpp"
#include "surface/remesh/triangle_guard.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// An edge by its ends: a side may be turned by another operation.
struct MeshEdge {
  VertexId a, b;
};

struct RemeshState {
  Mesh& mesh;
  const SurfaceModel& model;
  const CurveNetwork& network;
  const SurfaceSizes& sizes;
  const RemeshOptions& options;
  ConstraintTags tags;
  Tag<VertexId, Vec3> normals;  // at free vertices; zero on features
  Tag<FaceId, std::int32_t> groups;
  Tag<VertexId, double> wanted;  // the edge at each vertex, by the sizes
  double scale =
      1;  // of all wanted edges; changes from round to round, until the number of triangles is right

  [[nodiscard]] TriangleGuard guard() const { return {model, normals, options.least_turn_cosine}; }
  [[nodiscard]] Vec3 point(VertexId v) const { return mesh.point3(v); }
  [[nodiscard]] double wanted_edge(VertexId v) const { return scale * wanted[v]; }
  [[nodiscard]] double wanted_edge(VertexId a, VertexId b) const {
    return 0.5 * (wanted_edge(a) + wanted_edge(b));
  }
  // In wanted edges.
  [[nodiscard]] double relative_length(VertexId a, VertexId b) const {
    return length(point(b) - point(a)) / wanted_edge(a, b);
  }
  [[nodiscard]] double squared_length(VertexId a, VertexId b) const {
    const Vec3 d = point(b) - point(a);
    return dot(d, d);
  }
  // A valid side of an edge, or none if it is gone.
  [[nodiscard]] SideId side_of(MeshEdge edge) const {
    if (!mesh.alive(edge.a) || !mesh.alive(edge.b)) return {};
    const SideId s = mesh.find_side(edge.a, edge.b);
    return s.valid() ? s : mesh.find_side(edge.b, edge.a);
  }
  [[nodiscard]] std::array<VertexId, 3> corners(FaceId f) const {
    return {mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)};
  }
  [[nodiscard]] std::array<Vec3, 3> points(const std::array<VertexId, 3>& corners) const {
    return {point(corners[0]), point(corners[1]), point(corners[2])};
  }
  [[nodiscard]] Vec3 normal_of(FaceId f) const {
    const auto p = points(corners(f));
    return unit_normal(p[0], p[1], p[2]);
  }
};

// The edges of which wanted(SideId) holds, each once, as the side of smaller number sees it; in the order of
// sides.
template <class Wanted>
std::vector<MeshEdge> edges_where(const Mesh& mesh, const Wanted& wanted) {
  const auto sides = parallel::filter_indices(4 * mesh.face_slots(), [&](std::size_t i) {
    const SideId s(static_cast<std::uint32_t>(i));
    if (s.index() == 3 || !mesh.alive(s.face())) return false;
    const SideId t = mesh.neighbour(s);
    return (!t.valid() || s < t) && wanted(s);
  });
  std::vector<MeshEdge> edges;
  edges.reserve(sides.size());
  for (const std::uint32_t i : sides) edges.push_back({mesh.origin(SideId(i)), mesh.target(SideId(i))});
  return edges;
}

}  // namespace quarry
