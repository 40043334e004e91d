#include "engine/mesh/constraint.hpp"

namespace quarry {

PieceId PieceFinder::between(NodeId a, NodeId b) const {
  for (const PieceId id : at(a)) {
    const Piece& piece = lines_->pieces[id];
    if (piece.from == b || piece.to == b) return id;
  }
  return {};
}

}  // namespace quarry
