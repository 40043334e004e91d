#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/grid.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
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

// Problems found near one piece; nothing if there are none.
struct Problem {
  const char* what = nullptr;
  Vec2 place;
};

Problem first_problem(Problem a, const Problem& b) { return a.what != nullptr ? a : b; }

class Checker {
 public:
  Checker(const NodedLines& lines, double snap)
      : lines_(lines), snap_(snap), segments_(segments()), grid_(segments_, 4 * snap) {}

  void run() const {
    require_distinct_nodes();
    require_distinct_pieces();
    const auto check = [&](std::size_t size, auto&& one) {
      const Problem problem = parallel::reduce_ordered(
          size, Problem(),
          [&](std::size_t begin, std::size_t end) {
            Problem found;
            std::vector<std::uint32_t> near;
            for (std::size_t i = begin; i < end; ++i) found = first_problem(found, one(i, near));
            return found;
          },
          first_problem, 256);
      if (problem.what != nullptr) fail(problem.what, problem.place);
    };
    check(lines_.nodes.size(), [&](std::size_t n, auto& near) { return node_problem(NodeId(n), near); });
    check(lines_.pieces.size(), [&](std::size_t p, auto& near) { return piece_problem(PieceId(p), near); });
  }

 private:
  [[nodiscard]] std::vector<Segment> segments() const {
    std::vector<Segment> result;
    for (const Piece& piece : lines_.pieces)
      result.push_back({lines_.nodes[piece.from], lines_.nodes[piece.to]});
    return result;
  }

  void require_distinct_nodes() const {
    std::vector<Vec2> points = lines_.nodes.raw();
    std::sort(points.begin(), points.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const auto same = std::adjacent_find(points.begin(), points.end());
    if (same != points.end()) fail("two nodes in one place", *same);
  }

  void require_distinct_pieces() const {
    std::vector<std::pair<NodeId, NodeId>> ends;
    for (const Piece& piece : lines_.pieces) ends.push_back(std::minmax(piece.from, piece.to));
    std::sort(ends.begin(), ends.end());
    for (const auto& [from, to] : ends)
      if (from == to) fail("a piece without length", lines_.nodes[from]);
    const auto same = std::adjacent_find(ends.begin(), ends.end());
    if (same != ends.end()) fail("two pieces between the same nodes", lines_.nodes[same->first]);
  }

  Problem node_problem(NodeId node, std::vector<std::uint32_t>& near) const {
    const Vec2 p = lines_.nodes[node];
    grid_.find(Box2{p, p}.grown(snap_), near);
    for (const std::uint32_t id : near) {
      const Piece& piece = lines_.pieces[PieceId(id)];
      if (piece.from == node || piece.to == node) continue;
      if (squared_distance(p, segments_[id].from, segments_[id].to) < snap_ * snap_)
        return {"a node nearer than the snapping distance to a piece that does not end there", p};
    }
    return {};
  }

  // Pieces that meet elsewhere than at a shared node. Two that share a node overlap only if the far end of
  // one lies on the other, which the check of the nodes finds.
  Problem piece_problem(PieceId id, std::vector<std::uint32_t>& near) const {
    const auto [a, b] = segments_[id.value()];
    Box2 box;
    box.extend(a);
    box.extend(b);
    grid_.find(box, near);
    for (const std::uint32_t other : near) {
      if (other <= id.value() || shares_end(lines_.pieces[id], lines_.pieces[PieceId(other)])) continue;
      const auto [c, d] = segments_[other];
      if (meeting(a, b, c, d) != Meeting::kApart)
        return {"two pieces cross or touch", crossing_point(a, b, c, d)};
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
  struct Spoke {
    NodeId node;
    double angle;
  };
  std::vector<Spoke> spokes;
  for (const Piece& piece : lines.pieces) {
    const Vec2 along = lines.nodes[piece.to] - lines.nodes[piece.from];
    spokes.push_back({piece.from, std::atan2(along.y, along.x)});
    spokes.push_back({piece.to, std::atan2(-along.y, -along.x)});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return a.node != b.node ? a.node < b.node : a.angle < b.angle;
  });
  double smallest = std::numbers::pi;
  std::size_t first = 0;  // spoke of the node at hand
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    if (spokes[i].node != spokes[i - 1].node) {
      first = i;
      continue;
    }
    // To the spoke before, and around to the first.
    smallest = std::min({smallest, spokes[i].angle - spokes[i - 1].angle,
                         spokes[first].angle + 2 * std::numbers::pi - spokes[i].angle});
  }
  return smallest * 180 / std::numbers::pi;
}

}  // namespace quarry
