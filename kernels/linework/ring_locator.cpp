#include "kernels/linework/ring_locator.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/segment.hpp"

namespace quarry::linework {
namespace {

std::vector<Segment> segments_of(std::span<const Vec2> ring) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) segments.push_back({ring[i], ring[i + 1]});
  return segments;
}

Box2 box_of(std::span<const Vec2> points) {
  Box2 box;
  for (const Vec2 p : points) box.extend(p);
  return box;
}

}  // namespace

Rows::Rows(double low, double high, std::size_t count)
    : low_(low), height_((high - low) / static_cast<double>(count)), rows_(count) {}

std::size_t Rows::row(double height) const {
  if (!(height_ > 0)) return 0;
  return static_cast<std::size_t>(
      std::clamp((height - low_) / height_, 0.0, static_cast<double>(rows_.size() - 1)));
}

void Rows::enter(std::uint32_t id, double from, double to) {
  const auto [low, high] = std::minmax(from, to);
  for (std::size_t r = row(low); r <= row(high); ++r) rows_[r].push_back(id);
}

RingLocator::RingLocator(std::span<const Vec2> ring, double near)
    : segments_(segments_of(ring)),
      near_(near),
      box_(box_of(ring)),
      rows_(box_.low.y, box_.high.y, std::clamp<std::size_t>(segments_.size() / 2, 1, 4096)),
      grid_(segments_,
            std::max(4 * near, box_.longer_side() / std::sqrt(static_cast<double>(segments_.size())))) {
  for (std::uint32_t i = 0; i < segments_.size(); ++i) rows_.enter(i, segments_[i].from.y, segments_[i].to.y);
  box_ = box_.grown(near);
}

bool RingLocator::within(Vec2 p) const {
  bool inside = false;
  for (const std::uint32_t i : rows_.at(p.y))
    if (left_ray_crosses(p, segments_[i].from, segments_[i].to)) inside = !inside;
  return inside;
}

bool RingLocator::near(Vec2 p) const {
  std::vector<std::uint32_t> found;
  grid_.find(Box2{p, p}.grown(near_), found);
  return std::any_of(found.begin(), found.end(), [&](std::uint32_t i) {
    return squared_distance(p, segments_[i].from, segments_[i].to) <= near_ * near_;
  });
}

}  // namespace quarry::linework
