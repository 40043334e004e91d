// Two meshes are the same when they have the same faces and edges over the same points, in any order and with
// any numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

using ComparedPoint = std::array<double, 3>;

struct ComparedMesh {
  std::vector<std::pair<std::int32_t, std::vector<ComparedPoint>>>
      faces;  // region; corners from the smallest on
  std::vector<std::tuple<std::int32_t, std::int32_t, ComparedPoint, ComparedPoint>>
      edges;  // constraint, kind, ends in order

  friend bool operator==(const ComparedMesh&, const ComparedMesh&) = default;
};

inline ComparedPoint compared_point(const Mesh& mesh, VertexId v) {
  const Vec3 p = mesh.point3(v);
  return {p.x, p.y, p.z};
}

inline ComparedMesh compared(const Mesh& mesh) {
  ComparedMesh result;
  const MeshFileTags tags(mesh);
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    std::vector<ComparedPoint> corners;
    for (int k = 0; k < mesh.corner_count(f); ++k) corners.push_back(compared_point(mesh, mesh.corner(f, k)));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.faces.emplace_back(tags.region(f), corners);
  }
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    const ComparedPoint p = compared_point(mesh, a);
    const ComparedPoint q = compared_point(mesh, b);
    result.edges.emplace_back(tags.constraint(e), tags.kind(e), std::min(p, q), std::max(p, q));
  }
  std::sort(result.faces.begin(), result.faces.end());
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

}  // namespace quarry
