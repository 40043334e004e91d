#include "engine/geometry/grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

// More cells than items only cost memory.
constexpr std::size_t kCellsPerItem = 4;

// Sorts ids by cell, stably, and tells where each cell begins. cells and ids have the same size.
std::vector<std::uint32_t> sort_into_cells(std::size_t cell_count, std::vector<std::uint64_t> cells,
                                           std::vector<std::uint32_t>& ids) {
  parallel::stable_sort_by_key(cells, ids);
  std::vector<std::uint32_t> begin(cell_count + 1, static_cast<std::uint32_t>(cells.size()));
  // Each entry that is the first of its cell begins that, and the empty ones before it.
  parallel::for_each(cells.size(), [&](std::size_t i) {
    const std::size_t after_last = i == 0 ? 0 : cells[i - 1] + 1;
    for (std::size_t cell = after_last; cell <= cells[i]; ++cell) begin[cell] = static_cast<std::uint32_t>(i);
  });
  return begin;
}

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

bool boxes_meet(const Box2& box, const Segment& segment) {
  const auto [x_low, x_high] = std::minmax(segment.from.x, segment.to.x);
  const auto [y_low, y_high] = std::minmax(segment.from.y, segment.to.y);
  return x_low <= box.high.x && box.low.x <= x_high && y_low <= box.high.y && box.low.y <= y_high;
}

}  // namespace

CellFrame::CellFrame(const Box2& box, double side, std::size_t cell_limit)
    : low_(box.empty() ? Vec2{} : box.low), side_(side) {
  assert(side > 0);
  const double width = box.empty() ? 0 : box.width();
  const double height = box.empty() ? 0 : box.height();
  const auto cells = [](double extent, double by) { return std::floor(extent / by) + 1; };
  while (cells(width, side_) * cells(height, side_) > static_cast<double>(cell_limit)) side_ *= 2;
  columns_ = static_cast<std::uint32_t>(cells(width, side_));
  rows_ = static_cast<std::uint32_t>(cells(height, side_));
  const double largest =
      std::max({std::abs(low_.x), std::abs(low_.y), std::abs(low_.x + width), std::abs(low_.y + height)});
  slack_ = 16 * std::numeric_limits<double>::epsilon() * largest;
}

std::uint32_t CellFrame::number(double offset, std::uint32_t count) const {
  return static_cast<std::uint32_t>(std::clamp(offset / side_, 0.0, static_cast<double>(count - 1)));
}

CellFrame::Interval CellFrame::rows_of_segment(Vec2 a, Vec2 b) const {
  const auto [low, high] = std::minmax(a.y, b.y);
  return {row(low), row(high) + 1};
}

// The part of the segment within the row's strip of height, which is widened by what rounding may have moved.
CellFrame::Interval CellFrame::columns_of_segment(Vec2 a, Vec2 b, std::uint32_t row) const {
  const double strip_low = low_.y + row * side_ - slack_;
  const double strip_high = low_.y + (row + 1.0) * side_ + slack_;
  double t_low = 0;
  double t_high = 1;
  if (a.y != b.y) {
    const double t_at_low = std::clamp((strip_low - a.y) / (b.y - a.y), 0.0, 1.0);
    const double t_at_high = std::clamp((strip_high - a.y) / (b.y - a.y), 0.0, 1.0);
    std::tie(t_low, t_high) = std::minmax(t_at_low, t_at_high);
  }
  const double x_at_low = a.x + t_low * (b.x - a.x);
  const double x_at_high = a.x + t_high * (b.x - a.x);
  const auto [x_low, x_high] = std::minmax(x_at_low, x_at_high);
  return {column(x_low - slack_), column(x_high + slack_) + 1};
}

PointGrid::PointGrid(std::span<const Vec2> points, double side)
    : points_(points), frame_(box_of_points(points), side, kCellsPerItem * points.size() + 1) {
  std::vector<std::uint64_t> cells(points.size());
  ids_.resize(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) {
    cells[i] = frame_.index(frame_.column(points[i].x), frame_.row(points[i].y));
    ids_[i] = static_cast<std::uint32_t>(i);
  });
  begin_ = sort_into_cells(frame_.size(), std::move(cells), ids_);
}

void PointGrid::find(const Box2& box, std::vector<std::uint32_t>& ids) const {
  ids.clear();
  visit_near(box, [&](std::uint32_t id) {
    if (box.contains(points_[id])) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double side)
    : segments_(segments),
      frame_(box_of_segments(segments), std::max(side, least_side(segments)),
             kCellsPerItem * segments.size() + 1) {
  std::vector<std::uint32_t> offsets(segments.size());
  parallel::for_each(segments.size(), [&](std::size_t i) {
    std::uint32_t count = 0;
    frame_.for_each_cell_of_segment(segments[i].from, segments[i].to, [&](std::size_t) { ++count; });
    offsets[i] = count;
  });
  const std::uint32_t total = parallel::exclusive_scan(std::span(offsets));
  std::vector<std::uint64_t> cells(total);
  ids_.resize(total);
  parallel::for_each(segments.size(), [&](std::size_t i) {
    std::uint32_t at = offsets[i];
    frame_.for_each_cell_of_segment(segments[i].from, segments[i].to, [&](std::size_t cell) {
      cells[at] = cell;
      ids_[at++] = static_cast<std::uint32_t>(i);
    });
  });
  begin_ = sort_into_cells(frame_.size(), std::move(cells), ids_);
}

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
  parallel::for_each(points.size(), [&](std::size_t i) {
    cells[i] = frame_.index(frame_.column(points[i].x), frame_.row(points[i].y));
  });
  return parallel::sorted_order(std::move(cells));
}

}  // namespace quarry
