#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/grid.hpp"
#include "engine/geometry/pieces_around.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry {
namespace {

[[noreturn]] void fail(const char* what, Vec2 place) {
  throw Error(ErrorKind::kBug, fmt::format("cleaned lines: {} at {}; please report the input", what,
                                           format_point(place.x, place.y)));
}

bool shares_end(const Piece& a, const Piece& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

// What is wrong in a part of the lines; nothing if all is well.
struct Problem {
  const char* what = nullptr;
  Vec2 place;
};

// The first problem that find(index) gives for an index of [0, size), if any.
template <class Find>
void require_none(std::size_t size, std::size_t chunk, Find&& find) {
  const auto first = [](Problem a, const Problem& b) { return a.what != nullptr ? a : b; };
  const Problem problem = parallel::reduce_ordered(
      size, Problem(),
      [&](std::size_t begin, std::size_t end) {
        Problem found;
        for (std::size_t i = begin; i < end && found.what == nullptr; ++i) found = find(i);
        return found;
      },
      first, chunk);
  if (problem.what != nullptr) fail(problem.what, problem.place);
}

class Checker {
 public:
  Checker(const NodedLines& lines, double snap)
      : lines_(lines), snap_(snap), segments_(segments()), grid_(segments_, 4 * snap) {}

  void run() const {
    require_distinct_nodes();
    require_distinct_pieces();
    const std::vector<std::uint32_t> order = grid_.by_cells(lines_.nodes.raw());
    require_none(order.size(), 1024, [&](std::size_t i) { return node_problem(NodeId(order[i])); });
    require_none(grid_.cell_count(), 4096, [&](std::size_t cell) { return cell_problem(cell); });
  }

 private:
  [[nodiscard]] std::vector<Segment> segments() const {
    std::vector<Segment> result(lines_.pieces.size());
    parallel::for_each(result.size(), [&](std::size_t i) {
      const Piece& piece = lines_.pieces[PieceId(i)];
      result[i] = {lines_.nodes[piece.from], lines_.nodes[piece.to]};
    });
    return result;
  }

  // Sorted by y, then by x, two in one place follow each other.
  void require_distinct_nodes() const {
    const std::vector<Vec2>& nodes = lines_.nodes.raw();
    std::vector<std::uint64_t> keys(nodes.size());
    // Adding 0 makes one of both zeros.
    parallel::for_each(nodes.size(),
                       [&](std::size_t n) { keys[n] = parallel::ordered_bits(nodes[n].y + 0.0); });
    std::vector<std::uint32_t> order = parallel::sorted_order(keys);
    parallel::for_each(order.size(),
                       [&](std::size_t i) { keys[i] = parallel::ordered_bits(nodes[order[i]].x + 0.0); });
    parallel::stable_sort_by_key(keys, order);
    require_none(order.size(), parallel::kChunk, [&](std::size_t i) {
      const Vec2 p = nodes[order[i]];
      return i > 0 && nodes[order[i - 1]] == p ? Problem{"two nodes in one place", p} : Problem();
    });
  }

  void require_distinct_pieces() const {
    std::vector<std::uint64_t> keys(lines_.pieces.size());
    parallel::for_each(keys.size(), [&](std::size_t i) {
      const Piece& piece = lines_.pieces[PieceId(i)];
      const auto [low, high] = std::minmax(piece.from, piece.to);
      keys[i] = std::uint64_t{low.value()} << 32 | high.value();
    });
    const std::vector<std::uint32_t> order = parallel::sorted_order(keys);
    require_none(order.size(), parallel::kChunk, [&](std::size_t i) {
      const Piece& piece = lines_.pieces[PieceId(order[i])];
      const Vec2 place = lines_.nodes[piece.from];
      if (piece.from == piece.to) return Problem{"a piece without length", place};
      if (i > 0 && keys[order[i]] == keys[order[i - 1]])
        return Problem{"two pieces between the same nodes", place};
      return Problem();
    });
  }

  [[nodiscard]] Problem node_problem(NodeId node) const {
    const Vec2 p = lines_.nodes[node];
    Problem problem;
    grid_.visit_near(Box2{p, p}.grown(snap_), [&](std::uint32_t id) {
      const Piece& piece = lines_.pieces[PieceId(id)];
      if (piece.from == node || piece.to == node) return;
      if (squared_distance(p, segments_[id].from, segments_[id].to) < snap_ * snap_)
        problem = {"a node nearer than the snapping distance to a piece that does not end there", p};
    });
    return problem;
  }

  // Pieces that meet elsewhere than at a shared node. Two that share a node overlap only if the far end of
  // one lies on the other, which the check of the nodes finds.
  [[nodiscard]] Problem cell_problem(std::size_t cell) const {
    const std::span<const std::uint32_t> entries = grid_.entries(cell);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto [a, b] = segments_[entries[i]];
      for (std::size_t k = i + 1; k < entries.size(); ++k) {
        const auto [c, d] = segments_[entries[k]];
        if (shares_end(lines_.pieces[PieceId(entries[i])], lines_.pieces[PieceId(entries[k])])) continue;
        if (meeting(a, b, c, d) != Meeting::kApart)
          return {"two pieces cross or touch", crossing_point(a, b, c, d)};
      }
    }
    return {};
  }

  const NodedLines& lines_;
  double snap_;
  std::vector<Segment> segments_;
  SegmentGrid grid_;
};

}  // namespace

void require_noded(const NodedLines& lines, double snap) {
  if (!lines.pieces.empty()) Checker(lines, snap).run();
}

double smallest_angle(const NodedLines& lines) {
  const PiecesAround around(lines);
  const double smallest = parallel::reduce_ordered(
      lines.nodes.size(), std::numbers::pi,
      [&](std::size_t begin, std::size_t end) {
        double least = std::numbers::pi;
        std::vector<double> angles;
        for (std::size_t n = begin; n < end; ++n) {
          const NodeId node(n);
          angles.clear();
          for (const PieceId id : around.at(node)) {
            const Piece& piece = lines.pieces[id];
            const Vec2 along = lines.nodes[piece.to] - lines.nodes[piece.from];
            angles.push_back(piece.from == node ? std::atan2(along.y, along.x)
                                                : std::atan2(-along.y, -along.x));
          }
          std::sort(angles.begin(), angles.end());
          for (std::size_t i = 1; i < angles.size(); ++i) least = std::min(least, angles[i] - angles[i - 1]);
          if (angles.size() > 1)
            least = std::min(least, angles.front() + 2 * std::numbers::pi - angles.back());
        }
        return least;
      },
      [](double a, double b) { return std::min(a, b); });
  return smallest * 180 / std::numbers::pi;
}

}  // namespace quarry
