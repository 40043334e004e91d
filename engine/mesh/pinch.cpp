#include "engine/mesh/pinch.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace quarry {
namespace {

// The boundary sides of faces alive, by the vertex that they start at, then by number. A fan has one such
// side, its most clockwise one; the first of a vertex is its side_of.
std::vector<std::pair<VertexId, SideId>> first_sides_of_fans(const Mesh& mesh) {
  std::vector<std::pair<VertexId, SideId>> fans;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      if (!mesh.neighbour(s).valid()) fans.emplace_back(mesh.origin(s), s);
    }
  }
  std::sort(fans.begin(), fans.end());
  return fans;
}

}  // namespace

std::vector<FanTwin> pinch_twins(const Mesh& mesh) {
  std::vector<FanTwin> twins;
  const auto pinch = mesh.find_tag<VertexId, std::uint8_t>(kPinchTag);
  if (!pinch.valid()) return twins;
  std::vector<VertexId> shared;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && pinch[v] != 0) shared.push_back(v);
  const auto key = [&](VertexId v) {
    const Vec3 p = mesh.point3(v);
    return std::tuple(p.x, p.y, p.z, v);
  };
  std::sort(shared.begin(), shared.end(), [&](VertexId a, VertexId b) { return key(a) < key(b); });
  for (std::size_t i = 1, first = 0; i < shared.size(); ++i) {
    if (mesh.point3(shared[i]) == mesh.point3(shared[first]))
      twins.push_back({shared[first], shared[i]});
    else
      first = i;
  }
  std::sort(twins.begin(), twins.end(), [](const FanTwin& a, const FanTwin& b) { return a.twin < b.twin; });
  return twins;
}

std::vector<FanTwin> split_fans(Mesh& mesh) {
  const auto fans = first_sides_of_fans(mesh);
  std::vector<FanTwin> twins;
  for (std::size_t i = 1; i < fans.size(); ++i) {
    const auto [v, first] = fans[i];
    if (fans[i - 1].first != v) continue;
    const VertexId twin = mesh.grow_vertices(1);
    copy_point(mesh, v, mesh, twin);
    for (SideId s = first; s.valid(); s = mesh.turn_left(s)) mesh.set_corner(s, twin);
    mesh.set_side_of(twin, first);
    twins.push_back({v, twin});
  }
  return twins;
}

std::size_t split_pinches(Mesh& mesh, ConstraintTags tags) {
  const std::vector<FanTwin> twins = split_fans(mesh);
  for (const auto& [v, twin] : twins) tags.support[twin] = tags.support[v];
  return twins.size();
}

void mark_pinches(Mesh& mesh, ConstraintTags tags) {
  std::vector<std::pair<NodeId, VertexId>> ends;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && tags.support[v].is_node() && mesh.on_boundary(v))
      ends.emplace_back(tags.support[v].node(), v);
  std::sort(ends.begin(), ends.end());
  const auto shares = [&](std::size_t i, std::size_t k) {
    return k < ends.size() && ends[i].first == ends[k].first;
  };
  Tag<VertexId, std::uint8_t> pinch;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!shares(i, i + 1) && (i == 0 || !shares(i, i - 1))) continue;
    if (!pinch.valid()) pinch = mesh.add_tag<VertexId, std::uint8_t>(kPinchTag, 0);
    pinch[ends[i].second] = 1;
  }
}

}  // namespace quarry
