#include "engine/geometry/cell_frame.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

namespace quarry {

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

CellFrame CellFrame::within(const Box2& part, double side, std::size_t cell_limit) const {
  CellFrame result(part, side, cell_limit);
  result.slack_ = slack_;
  return result;
}

Box2 CellFrame::box(std::size_t cell) const {
  const std::size_t row = cell / columns_;
  const std::size_t column = cell - row * columns_;
  const Vec2 low = low_ + side_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
  return Box2{low, low + Vec2{side_, side_}}.grown(slack_);
}

std::uint32_t CellFrame::number(double offset, std::uint32_t count) const {
  return static_cast<std::uint32_t>(std::clamp(offset / side_, 0.0, static_cast<double>(count - 1)));
}

CellFrame::Interval CellFrame::rows_of_segment(Vec2 a, Vec2 b) const {
  const auto [low, high] = std::minmax(a.y, b.y);
  if (high + slack_ < low_.y || low - slack_ > low_.y + rows_ * side_) return {0, 0};
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
  if (x_high + slack_ < low_.x || x_low - slack_ > low_.x + columns_ * side_) return {0, 0};
  return {column(x_low - slack_), column(x_high + slack_) + 1};
}

}  // namespace quarry
