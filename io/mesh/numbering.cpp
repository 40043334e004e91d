#include "io/mesh/numbering.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
LiveNumbering::LiveNumbering(const Mesh& mesh)
    : vertex_count_(mesh.count_alive_vertices()), face_count_(mesh.count_alive_faces()) {
  const std::vector<FanTwin> twins = pinch_twins(mesh);
  const auto hidden = [&](std::size_t i) {
    const VertexId v(i);
    const auto at = std::lower_bound(twins.begin(), twins.end(), v,
                                     [](const FanTwin& twin, VertexId other) { return twin.twin < other; });
    return at != twins.end() && at->twin == v;
  };
  vertex_count_ -= twins.size();
  if (vertex_count_ != mesh.vertex_slots()) {
    vertices_ = parallel::filter_indices(
        mesh.vertex_slots(), [&](std::size_t i) { return mesh.alive(VertexId(i)) && !hidden(i); });
    number_of_.assign(mesh.vertex_slots(), VertexId::kNone);
    parallel::for_each(vertices_.size(),
                       [&](std::size_t i) { number_of_[vertices_[i]] = static_cast<std::uint32_t>(i); });
    for (const auto& [first, twin] : twins) number_of_[twin.value()] = number_of_[first.value()];
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
