#include "engine/geometry/grid.hpp"

#include <algorithm>
#include <utility>

#include "engine/geometry/cell_tree_build.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

template <class Item, class Extend>
Box2 box_of(std::span<const Item> items, Extend&& extend) {
  return parallel::reduce_ordered(
      items.size(), Box2{},
      [&](std::size_t begin, std::size_t end) {
        Box2 box;
        for (std::size_t i = begin; i < end; ++i) extend(box, items[i]);
        return box;
      },
      [](Box2 box, const Box2& part) {
        if (part.empty()) return box;
        box.extend(part.low);
        box.extend(part.high);
        return box;
      });
}

Box2 box_of_points(std::span<const Vec2> points) {
  return box_of(points, [](Box2& box, Vec2 point) { box.extend(point); });
}

Box2 box_of_segments(std::span<const Segment> segments) {
  return box_of(segments, [](Box2& box, const Segment& segment) {
    box.extend(segment.from);
    box.extend(segment.to);
  });
}

// The side from which on a segment passes through few cells on average, so that the entries stay linear in
// the number of segments.
double least_side(std::span<const Segment> segments) {
  constexpr double kCellsPerSegment = 8;
  const double total = parallel::reduce_ordered(
      segments.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += distance(segments[i].from, segments[i].to);
        return sum;
      },
      [](double sum, double part) { return sum + part; });
  return segments.empty() ? 0 : total / (kCellsPerSegment * static_cast<double>(segments.size()));
}

struct PointItems {
  std::span<const Vec2> points;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  template <class Visit>
  void for_each_cell(const CellFrame& frame, std::size_t i, Visit&& visit) const {
    visit(frame.index(points[i]));
  }
  double extend(Box2& box, std::size_t i, const Box2&) const {
    box.extend(points[i]);
    return 0;
  }
};

// The parameters between which the coordinate from + t * (to - from) lies between low and high, cut to what
// they are already.
void clip(double from, double to, double low, double high, double& begin, double& end) {
  if (from == to) {
    if (from < low || from > high) end = -1;
    return;
  }
  const auto [t_low, t_high] = std::minmax({(low - from) / (to - from), (high - from) / (to - from)});
  begin = std::max(begin, t_low);
  end = std::min(end, t_high);
}

struct SegmentItems {
  std::span<const Segment> segments;

  [[nodiscard]] std::size_t size() const { return segments.size(); }
  template <class Visit>
  void for_each_cell(const CellFrame& frame, std::size_t i, Visit&& visit) const {
    frame.for_each_cell_of_segment(segments[i].from, segments[i].to, visit);
  }
  double extend(Box2& box, std::size_t i, const Box2& within) const {
    const auto [a, b] = segments[i];
    double begin = 0;
    double end = 1;
    clip(a.x, b.x, within.low.x, within.high.x, begin, end);
    clip(a.y, b.y, within.low.y, within.high.y, begin, end);
    if (begin > end) return 0;
    box.extend(point_at(begin, a, b));
    box.extend(point_at(end, a, b));
    return (end - begin) * distance(a, b);
  }
};

bool boxes_meet(const Box2& box, const Segment& segment) {
  const auto [x_low, x_high] = std::minmax(segment.from.x, segment.to.x);
  const auto [y_low, y_high] = std::minmax(segment.from.y, segment.to.y);
  return x_low <= box.high.x && box.low.x <= x_high && y_low <= box.high.y && box.low.y <= y_high;
}

}  // namespace

PointGrid::PointGrid(std::span<const Vec2> points, double side)
    : points_(points), tree_(CellTreeBuilder(PointItems{points}, side).build(box_of_points(points), side)) {}

void PointGrid::find(const Box2& box, std::vector<std::uint32_t>& ids) const {
  ids.clear();
  visit_near(box, [&](std::uint32_t id) {
    if (box.contains(points_[id])) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double side)
    : segments_(segments),
      tree_(CellTreeBuilder(SegmentItems{segments}, side)
                .build(box_of_segments(segments), std::max(side, least_side(segments)))) {}

void SegmentGrid::find(const Box2& box, std::vector<std::uint32_t>& ids) const {
  ids.clear();
  visit_near(box, [&](std::uint32_t id) {
    if (boxes_meet(box, segments_[id])) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

std::vector<std::uint32_t> SegmentGrid::by_cells(std::span<const Vec2> points) const {
  std::vector<std::uint64_t> cells(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) { cells[i] = tree_.cell_of(points[i]); });
  return parallel::sorted_order(std::move(cells));
}

}  // namespace quarry
