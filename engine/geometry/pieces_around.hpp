// The pieces that end at each node of cleaned lines, in compressed rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

class PiecesAround {
 public:
  explicit PiecesAround(const NodedLines& lines) : begin_(lines.nodes.size() + 1, 0) {
    for (const Piece& piece : lines.pieces) {
      ++begin_[piece.from.value()];
      ++begin_[piece.to.value()];
    }
    (void)parallel::exclusive_scan(std::span(begin_));
    pieces_.resize(2 * lines.pieces.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const PieceId id : IdRange<PieceId>(lines.pieces.size())) {
      pieces_[next[lines.pieces[id].from.value()]++] = id;
      pieces_[next[lines.pieces[id].to.value()]++] = id;
    }
  }

  // Ascending.
  [[nodiscard]] std::span<const PieceId> at(NodeId node) const {
    const std::uint32_t begin = begin_[node.value()];
    return std::span(pieces_).subspan(begin, begin_[node.value() + 1] - begin);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<PieceId> pieces_;
};

}  // namespace quarry
