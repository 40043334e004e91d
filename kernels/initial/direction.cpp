#include "kernels/initial/direction.hpp"

#include <cmath>
#include <numbers>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// A mean shorter than this share of the total length is rounding, not a direction.
constexpr double kNoDirection = 1e-9;

struct DirectionSum {
  Vec2 sum;
  double total = 0;
};

Vec2 square(Vec2 z) { return {z.x * z.x - z.y * z.y, 2 * z.x * z.y}; }

}  // namespace

double dominant_direction(const NodedLines& lines) {
  const DirectionSum all = parallel::reduce_ordered(
      lines.pieces.size(), DirectionSum(),
      [&](std::size_t begin, std::size_t end) {
        DirectionSum part;
        for (std::size_t i = begin; i < end; ++i) {
          if (lines.numbers(PieceId(i)).empty()) continue;
          const Piece& piece = lines.pieces[PieceId(i)];
          const Vec2 along = lines.nodes[piece.to] - lines.nodes[piece.from];
          const double weight = length(along);
          if (!(weight > 0)) continue;
          part.sum = part.sum + weight * square(square((1 / weight) * along));
          part.total += weight;
        }
        return part;
      },
      [](DirectionSum a, DirectionSum b) {
        return DirectionSum{a.sum + b.sum, a.total + b.total};
      });
  if (!(length(all.sum) > kNoDirection * all.total)) return 0;
  const double degrees = std::atan2(all.sum.y, all.sum.x) / 4 * 180 / std::numbers::pi;
  return degrees >= 45 ? degrees - 90 : degrees;
}

}  // namespace quarry
