#include "kernels/smooth/slide.hpp"

#include "engine/geometry/segment.hpp"

namespace quarry {

Vec2 Slide::allowed(VertexId v, Vec2 p) const {
  const Support support = tags_.support[v];
  if (!support.slides()) return p;
  const Piece& piece = lines_->pieces[support.piece()];
  return closest_point(p, lines_->nodes[piece.from], lines_->nodes[piece.to]);
}

Vec2 Slide::direction(VertexId v) const {
  const Support support = tags_.support[v];
  if (!support.slides()) return {};
  const Piece& piece = lines_->pieces[support.piece()];
  const Vec2 along = lines_->nodes[piece.to] - lines_->nodes[piece.from];
  return (1.0 / length(along)) * along;
}

}  // namespace quarry
