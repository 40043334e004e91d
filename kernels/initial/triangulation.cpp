#include "kernels/initial/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/initial/edge_rings.hpp"

namespace quarry {
namespace {

// A planar graph has fewer edges than three times its vertices, so that a part never runs out of edges.
constexpr std::size_t kEdgesPerPoint = 3;

void check_finite(std::span<const Vec2> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
      throw Error(ErrorKind::kInput,
                  fmt::format("point {} is not finite: remove it before triangulating", i));
}

// The points from left to right; on one vertical line, upwards.
std::vector<std::uint32_t> order_by_x(std::span<const Vec2> points) {
  // Adding zero makes -0 and 0 one key.
  const auto sort_by = [&](std::vector<std::uint32_t>& order, auto&& coordinate) {
    std::vector<std::uint64_t> keys(order.size());
    parallel::for_each(order.size(), [&](std::size_t i) {
      keys[i] = parallel::ordered_bits(coordinate(points[order[i]]) + 0.0);
    });
    parallel::stable_sort_by_key(keys, order);
  };
  std::vector<std::uint32_t> order(points.size());
  parallel::for_each(order.size(), [&](std::size_t i) { order[i] = static_cast<std::uint32_t>(i); });
  sort_by(order, [](Vec2 p) { return p.y; });
  sort_by(order, [](Vec2 p) { return p.x; });
  return order;
}

void check_distinct(std::span<const Vec2> points, const std::vector<std::uint32_t>& order) {
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i]] == points[order[i - 1]])
      throw Error(ErrorKind::kInput,
                  fmt::format("points {} and {} are the same, {}: remove one", order[i - 1], order[i],
                              format_point(points[order[i]].x, points[order[i]].y)));
}

class DelaunayBuilder {
 public:
  explicit DelaunayBuilder(std::span<const Vec2> points)
      : order_(order_by_x(points)), points_(points.size()), rings_(kEdgesPerPoint * points.size()) {
    check_distinct(points, order_);
    // Half the root of the number of points: strips are then about two points wide, and every merge is short.
    strip_count_ = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::sqrt(static_cast<double>(points.size())) * 0.5));
    parallel::for_each(
        strip_count_, [&](std::size_t strip) { sort_strip(points, strip); }, 1);
  }

  void run() {
    std::vector<Part> parts(strip_count_);
    parallel::for_each(
        strip_count_, [&](std::size_t strip) { parts[strip] = make_strip(strip); }, 1);
    for (std::size_t step = 1; step < strip_count_; step *= 2) {
      const std::size_t pairs = (strip_count_ - step + 2 * step - 1) / (2 * step);
      parallel::for_each(
          pairs,
          [&](std::size_t i) {
            parts[2 * step * i] = merge(parts[2 * step * i], parts[2 * step * i + step]);
          },
          1);
    }
    outer_ = RingEdges(rings_.size(), 0);
    for_each_outer_edge(parts[0], [&](RingEdgeId e) { outer_[e] = 1; });
  }

  [[nodiscard]] std::vector<FaceCorners> faces() const {
    const auto firsts = parallel::filter_indices(rings_.size(), [&](std::size_t i) {
      const RingEdgeId e(i);
      if (!rings_.used(e) || outer_[e] != 0) return false;
      return e < rings_.left_next(e) && e < rings_.left_next(rings_.left_next(e));
    });
    std::vector<FaceCorners> faces(firsts.size());
    parallel::for_each(firsts.size(), [&](std::size_t i) {
      const RingEdgeId e(firsts[i]);
      faces[i] = {given(rings_.origin(e)), given(rings_.target(e)), given(rings_.target(rings_.left_next(e))),
                  VertexId()};
    });
    return faces;
  }

 private:
  using RingEdges = IdVector<RingEdgeId, std::uint8_t>;

  // A triangulated part: hull edges from its first point counter-clockwise and from its last point clockwise,
  // where first and last are in the direction in which it will be merged.
  struct Part {
    RingEdgeId from_first;
    RingEdgeId from_last;
    EdgePool pool;
  };

  [[nodiscard]] std::size_t strip_begin(std::size_t strip) const {
    return points_.size() * strip / strip_count_;
  }
  [[nodiscard]] VertexId given(VertexId v) const { return VertexId(order_[v.value()]); }
  [[nodiscard]] Vec2 point(VertexId v) const { return points_[v.value()]; }

  // Inside a strip parts are merged upwards. That is the merge from left to right turned by a quarter, so
  // points of equal height go from right to left.
  void sort_strip(std::span<const Vec2> points, std::size_t strip) {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(strip_begin(strip));
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(strip_begin(strip + 1));
    std::sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      const Vec2 a = points[i];
      const Vec2 b = points[j];
      return a.y < b.y || (a.y == b.y && a.x > b.x);
    });
    for (std::size_t i = strip_begin(strip); i < strip_begin(strip + 1); ++i) points_[i] = points[order_[i]];
  }

  Part make_strip(std::size_t strip) {
    Part part = make_part(strip_begin(strip), strip_begin(strip + 1));
    turn(part);
    return part;
  }

  Part make_part(std::size_t begin, std::size_t end) {
    if (end - begin <= 3) return make_smallest(begin, end);
    const std::size_t middle = begin + (end - begin) / 2;
    const Part low = make_part(begin, middle);
    return merge(low, make_part(middle, end));
  }

  // Two or three points.
  Part make_smallest(std::size_t begin, std::size_t end) {
    EdgePool pool = rings_.make_pool(kEdgesPerPoint * begin, kEdgesPerPoint * end);
    const VertexId p(begin), q(begin + 1), r(begin + 2);
    const RingEdgeId a = rings_.make_edge(p, q, pool);
    if (end - begin == 2) return {a, EdgeRings::reverse(a), pool};
    const RingEdgeId b = rings_.make_edge(q, r, pool);
    rings_.insert_after(EdgeRings::reverse(a), b);
    const double turn = orient2d(point(p), point(q), point(r));
    if (turn == 0) return {a, EdgeRings::reverse(b), pool};
    const RingEdgeId c = rings_.connect(b, a, pool);
    if (turn > 0) return {a, EdgeRings::reverse(b), pool};
    return {EdgeRings::reverse(c), c, pool};
  }

  // Visits the edges of the outer face, clockwise around the part.
  template <class Visit>
  void for_each_outer_edge(const Part& part, Visit&& visit) const {
    const RingEdgeId start = EdgeRings::reverse(part.from_first);
    RingEdgeId e = start;
    do {
      visit(e);
      e = rings_.left_next(e);
    } while (e != start);
  }

  // From merging upwards to merging to the right: finds the leftmost and the rightmost point.
  void turn(Part& part) const {
    const auto left_of = [&](VertexId a, VertexId b) {
      const Vec2 p = point(a);
      const Vec2 q = point(b);
      return p.x < q.x || (p.x == q.x && p.y < q.y);
    };
    RingEdgeId into_left = EdgeRings::reverse(part.from_first);
    RingEdgeId from_right = into_left;
    for_each_outer_edge(part, [&](RingEdgeId e) {
      if (left_of(rings_.target(e), rings_.target(into_left))) into_left = e;
      if (left_of(rings_.origin(from_right), rings_.origin(e))) from_right = e;
    });
    part.from_first = EdgeRings::reverse(into_left);
    part.from_last = from_right;
  }

  [[nodiscard]] bool left_turn(VertexId a, VertexId b, VertexId c) const {
    return orient2d(point(a), point(b), point(c)) > 0;
  }
  [[nodiscard]] bool in_circle(VertexId a, VertexId b, VertexId c, VertexId d) const {
    return incircle(point(a), point(b), point(c), point(d)) > 0;
  }
  // True if e leaves its origin to the side of base on which the merge proceeds.
  [[nodiscard]] bool above(RingEdgeId e, RingEdgeId base) const {
    return left_turn(rings_.target(e), rings_.target(base), rings_.origin(base));
  }

  // Joins two parts of which all points of the first come before all points of the second.
  Part merge(Part first, Part second) {
    EdgePool pool = rings_.join_pools(first.pool, second.pool);
    RingEdgeId base = connect_below(first, second, pool);
    for (;;) {
      const RingEdgeId left = left_candidate(base, pool);
      const RingEdgeId right = right_candidate(base, pool);
      const bool left_valid = above(left, base);
      const bool right_valid = above(right, base);
      if (!left_valid && !right_valid) break;
      const bool take_right =
          !left_valid || (right_valid && in_circle(rings_.target(left), rings_.origin(left),
                                                   rings_.origin(right), rings_.target(right)));
      base = take_right ? rings_.connect(right, EdgeRings::reverse(base), pool)
                        : rings_.connect(EdgeRings::reverse(base), EdgeRings::reverse(left), pool);
    }
    return {first.from_first, second.from_last, pool};
  }

  // The lower common tangent, directed from the second part to the first.
  RingEdgeId connect_below(Part& first, Part& second, EdgePool& pool) {
    RingEdgeId inner_first = first.from_last;
    RingEdgeId inner_second = second.from_first;
    for (;;) {
      if (left_turn(rings_.origin(inner_first), rings_.target(inner_first), rings_.origin(inner_second)))
        inner_first = rings_.left_next(inner_first);
      else if (left_turn(rings_.origin(inner_first), rings_.target(inner_second),
                         rings_.origin(inner_second)))
        inner_second = rings_.right_previous(inner_second);
      else
        break;
    }
    const RingEdgeId base = rings_.connect(EdgeRings::reverse(inner_second), inner_first, pool);
    if (rings_.origin(inner_first) == rings_.origin(first.from_first))
      first.from_first = EdgeRings::reverse(base);
    if (rings_.origin(inner_second) == rings_.origin(second.from_last)) second.from_last = base;
    return base;
  }

  // The edge of the first part that may become a side of the next triangle; edges whose circle holds the next
  // point are deleted on the way.
  RingEdgeId left_candidate(RingEdgeId base, EdgePool& pool) {
    RingEdgeId e = rings_.next(EdgeRings::reverse(base));
    if (!above(e, base)) return e;
    while (
        in_circle(rings_.target(base), rings_.origin(base), rings_.target(e), rings_.target(rings_.next(e))))
      rings_.delete_edge(std::exchange(e, rings_.next(e)), pool);
    return e;
  }
  RingEdgeId right_candidate(RingEdgeId base, EdgePool& pool) {
    RingEdgeId e = rings_.previous(base);
    if (!above(e, base)) return e;
    while (in_circle(rings_.target(base), rings_.origin(base), rings_.target(e),
                     rings_.target(rings_.previous(e))))
      rings_.delete_edge(std::exchange(e, rings_.previous(e)), pool);
    return e;
  }

  std::vector<std::uint32_t> order_;  // number in the input of each point as sorted
  std::vector<Vec2> points_;          // sorted
  std::size_t strip_count_ = 1;
  EdgeRings rings_;
  RingEdges outer_;  // 1: the outer face is on its left
};

}  // namespace

Mesh delaunay_triangulation(std::span<const Vec2> points) {
  check_finite(points);
  if (points.size() < 3)
    throw Error(ErrorKind::kInput, fmt::format("a triangulation needs three points, not {}", points.size()));
  DelaunayBuilder builder(points);
  builder.run();
  const std::vector<FaceCorners> faces = builder.faces();
  if (faces.empty())
    throw Error(ErrorKind::kInput,
                fmt::format("all {} points lie on one line, at {}: a triangulation needs one that does not",
                            points.size(), format_point(points[0].x, points[0].y)));
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) {
    x[i] = points[i].x;
    y[i] = points[i].y;
  });
  return build_mesh(std::move(x), std::move(y), faces);
}

}  // namespace quarry
