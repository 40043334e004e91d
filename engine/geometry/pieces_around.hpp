// The pieces that end at each node of cleaned lines.
#pragma once

#include "engine/geometry/ends_around.hpp"

namespace quarry {

class PiecesAround : public EndsAround<PieceId> {
 public:
  explicit PiecesAround(const NodedLines& lines) : EndsAround(lines.nodes.size(), lines.pieces.raw()) {}
};

}  // namespace quarry
