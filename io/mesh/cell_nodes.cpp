#include "io/mesh/cell_nodes.hpp"

#include <map>

namespace quarry {

CellNodes::CellNodes(const Mesh& mesh, const LiveNumbering& numbering, ElementOrder order)
    : mesh_(&mesh), numbering_(&numbering), order_(order), vertices_(numbering.vertex_count()) {
  if (order == ElementOrder::kLinear) return;
  number_middles();
  if (order == ElementOrder::kBiquadratic) number_centres();
}

void CellNodes::number_middles() {
  middle_of_side_.assign(4 * mesh_->face_slots(), VertexId::kNone);
  const auto add = [&](VertexId a, VertexId b) {
    middles_.emplace_back(a, b);
    return static_cast<std::uint32_t>(vertices_ + middles_.size() - 1);
  };
  for (std::size_t i = 0; i < numbering_->face_count(); ++i) {
    const FaceId f = numbering_->face(i);
    for (int k = 0; k < mesh_->corner_count(f); ++k) {
      const SideId side(f, k), across = mesh_->neighbour(side);
      if (middle_of_side_[side.value()] != VertexId::kNone) continue;
      const std::uint32_t middle = add(mesh_->origin(side), mesh_->target(side));
      middle_of_side_[side.value()] = middle;
      if (across.valid()) middle_of_side_[across.value()] = middle;
    }
  }
  // A piece of several lines is an edge for each of them, with one middle.
  std::map<std::pair<VertexId, VertexId>, std::uint32_t> apart;
  for (const EdgeId e : numbering_->edges()) {
    const auto [a, b] = mesh_->edge_ends(e);
    SideId side = mesh_->find_side(a, b);
    if (!side.valid()) side = mesh_->find_side(b, a);
    if (side.valid()) {
      middle_of_edge_.push_back(middle_of_side_[side.value()]);
      continue;
    }
    const auto [at, is_new] = apart.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (is_new) at->second = add(a, b);
    middle_of_edge_.push_back(at->second);
  }
}

void CellNodes::number_centres() {
  centre_of_face_.assign(mesh_->face_slots(), VertexId::kNone);
  for (std::size_t i = 0; i < numbering_->face_count(); ++i) {
    const FaceId f = numbering_->face(i);
    if (mesh_->corner_count(f) != 4) continue;
    centre_of_face_[f.value()] = static_cast<std::uint32_t>(vertices_ + middles_.size() + centres_.size());
    centres_.push_back(f);
  }
}

// Sums of two do not depend on their order: the middles of edges that lie on one another are equal.
Vec3 CellNodes::point(std::size_t node) const {
  if (node < vertices_) return mesh_->point3(numbering_->vertex(node));
  node -= vertices_;
  if (node < middles_.size())
    return 0.5 * (mesh_->point3(middles_[node].first) + mesh_->point3(middles_[node].second));
  const FaceId f = centres_[node - middles_.size()];
  const auto corner = [&](int k) { return mesh_->point3(mesh_->corner(f, k)); };
  return 0.25 * ((corner(0) + corner(2)) + (corner(1) + corner(3)));
}

}  // namespace quarry
