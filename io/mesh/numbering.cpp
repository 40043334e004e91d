#include "io/mesh/numbering.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Vertices that a file leaves out, ascending, each with the one of smaller id that stands for it: the fans at
// a point where the domain touches itself.
std::vector<std::pair<std::uint32_t, std::uint32_t>> hidden_twins(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> hidden;
  const auto pinch = mesh.find_tag<VertexId, std::uint8_t>(kPinchTag);
  if (!pinch.valid()) return hidden;
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
      hidden.emplace_back(shared[i].value(), shared[first].value());
    else
      first = i;
  }
  std::sort(hidden.begin(), hidden.end());
  return hidden;
}

}  // namespace

LiveNumbering::LiveNumbering(const Mesh& mesh)
    : vertex_count_(mesh.count_alive_vertices()), face_count_(mesh.count_alive_faces()) {
  const auto twins = hidden_twins(mesh);
  const auto hidden = [&](std::size_t i) {
    const auto at =
        std::lower_bound(twins.begin(), twins.end(), std::pair(static_cast<std::uint32_t>(i), 0U));
    return at != twins.end() && at->first == i;
  };
  vertex_count_ -= twins.size();
  if (vertex_count_ != mesh.vertex_slots()) {
    vertices_ = parallel::filter_indices(
        mesh.vertex_slots(), [&](std::size_t i) { return mesh.alive(VertexId(i)) && !hidden(i); });
    number_of_.assign(mesh.vertex_slots(), VertexId::kNone);
    parallel::for_each(vertices_.size(),
                       [&](std::size_t i) { number_of_[vertices_[i]] = static_cast<std::uint32_t>(i); });
    for (const auto& [twin, first] : twins) number_of_[twin] = number_of_[first];
  }
  if (face_count_ != mesh.face_slots())
    faces_ =
        parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return mesh.alive(FaceId(i)); });
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    if (mesh.alive(a) && mesh.alive(b)) edges_.push_back(e);
  }
}

void LiveNumbering::keep_edges(const std::vector<std::uint32_t>& places) {
  std::vector<EdgeId> kept;
  for (const std::uint32_t place : places) kept.push_back(edges_[place]);
  edges_ = std::move(kept);
}

}  // namespace quarry
