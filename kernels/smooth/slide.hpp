// Where a vertex may go: anywhere, or along its straight piece between the piece's two nodes.
#pragma once

#include "engine/mesh/constraint.hpp"

namespace quarry {

class Slide {
 public:
  Slide(const Mesh& mesh, ConstraintTags tags, const NodedLines& lines)
      : mesh_(&mesh), tags_(tags), lines_(&lines) {}

  // Fixed vertices, nodes, and free vertices on the rim of the mesh never move.
  [[nodiscard]] bool movable(VertexId v) const {
    if (!mesh_->alive(v)) return false;
    const Support support = tags_.support[v];
    return support.slides() || (support.is_free() && !mesh_->on_boundary(v));
  }

  // The place nearest to p that v may take: p itself, or the point of its piece, which is constructed from
  // the nearer node so that it lies on the piece within a rounding of its coordinates.
  [[nodiscard]] Vec2 allowed(VertexId v, Vec2 p) const;

  // The direction in which a sliding vertex may go, of length 1; zero if v is free.
  [[nodiscard]] Vec2 direction(VertexId v) const;

 private:
  const Mesh* mesh_;
  ConstraintTags tags_;
  const NodedLines* lines_;
};

}  // namespace quarry
