// The nodes of elements of first and second order. Those of second order have one more in the middle of each
// edge, which the elements around it share, and, if they are biquadratic, one in the middle of each quad.
// Edges of finished meshes are straight, on lines and on the boundary too, and so are those of their elements
// of second order.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

// Numbers the vertices as LiveNumbering does, then the middles of edges in the order of the faces and sides
// that they are met at, then those of edges that are no side of a face, then those of quads.
class CellNodes {
 public:
  CellNodes(const Mesh& mesh, const LiveNumbering& numbering, ElementOrder order);

  [[nodiscard]] std::size_t count() const { return vertices_ + middles_.size() + centres_.size(); }
  [[nodiscard]] Vec3 point(std::size_t node) const;

  // Corners, the middle of each side from the first on, the centre.
  [[nodiscard]] int face_count(FaceId f) const {
    const int corners = mesh_->corner_count(f);
    if (order_ == ElementOrder::kLinear) return corners;
    return 2 * corners + (corners == 4 && order_ == ElementOrder::kBiquadratic ? 1 : 0);
  }
  [[nodiscard]] std::uint32_t face_node(FaceId f, int k) const {
    const int corners = mesh_->corner_count(f);
    if (k < corners) return numbering_->number(mesh_->corner(f, k));
    return k < 2 * corners ? middle_of_side_[SideId(f, k - corners).value()] : centre_of_face_[f.value()];
  }
  // Ends, middle. edge: a place in LiveNumbering::edges().
  [[nodiscard]] int edge_count() const { return order_ == ElementOrder::kLinear ? 2 : 3; }
  [[nodiscard]] std::uint32_t edge_node(std::size_t edge, int k) const {
    const auto [a, b] = mesh_->edge_ends(numbering_->edges()[edge]);
    return k == 2 ? middle_of_edge_[edge] : numbering_->number(k == 0 ? a : b);
  }

 private:
  void number_middles();
  void number_centres();

  const Mesh* mesh_;
  const LiveNumbering* numbering_;
  ElementOrder order_;
  std::size_t vertices_;
  std::vector<std::pair<VertexId, VertexId>> middles_;  // what they lie between
  std::vector<FaceId> centres_;
  std::vector<std::uint32_t> middle_of_side_, middle_of_edge_, centre_of_face_;
};

}  // namespace quarry
