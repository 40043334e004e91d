#include "engine/mesh/constraint.hpp"

#include <span>

#include "engine/parallel/parallel.hpp"

namespace quarry {

PieceFinder::PieceFinder(const NodedLines& lines)
    : lines_(&lines), begin_(lines.nodes.size() + 1, 0), pieces_(2 * lines.pieces.size()) {
  for (const Piece& piece : lines.pieces) {
    ++begin_[piece.from.value()];
    ++begin_[piece.to.value()];
  }
  parallel::exclusive_scan(std::span(begin_));
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < lines.pieces.size(); ++i) {
    const Piece& piece = lines.pieces[PieceId(i)];
    pieces_[at[piece.from.value()]++] = PieceId(i);
    pieces_[at[piece.to.value()]++] = PieceId(i);
  }
}

PieceId PieceFinder::between(NodeId a, NodeId b) const {
  for (const PieceId id : at(a)) {
    const Piece& piece = lines_->pieces[id];
    if (piece.from == b || piece.to == b) return id;
  }
  return {};
}

}  // namespace quarry
