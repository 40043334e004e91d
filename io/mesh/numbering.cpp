#include "io/mesh/numbering.hpp"

#include "engine/parallel/parallel.hpp"

namespace quarry {

LiveNumbering::LiveNumbering(const Mesh& mesh)
    : vertex_count_(mesh.count_alive_vertices()), face_count_(mesh.count_alive_faces()) {
  if (vertex_count_ != mesh.vertex_slots()) {
    vertices_ =
        parallel::filter_indices(mesh.vertex_slots(), [&](std::size_t i) { return mesh.alive(VertexId(i)); });
    number_of_.assign(mesh.vertex_slots(), VertexId::kNone);
    parallel::for_each(vertices_.size(),
                       [&](std::size_t i) { number_of_[vertices_[i]] = static_cast<std::uint32_t>(i); });
  }
  if (face_count_ != mesh.face_slots())
    faces_ =
        parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return mesh.alive(FaceId(i)); });
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    if (mesh.alive(a) && mesh.alive(b)) edges_.push_back(e);
  }
}

}  // namespace quarry
