#include "kernels/cleanup/irregular_price.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/geometry/segment.hpp"

namespace quarry {
namespace {

class NearSegments {
 public:
  NearSegments(std::vector<Segment> segments, const LinePrice& price)
      : segments_(std::move(segments)), price_(price), grid_(segments_, 2 * price.distance) {}
  NearSegments(const NearSegments&) = delete;
  NearSegments& operator=(const NearSegments&) = delete;

  [[nodiscard]] double at(Vec2 p) const {
    const double squared = squared_distance_of(p);
    const double near = price_.distance;
    if (squared <= near * near) return price_.factor;
    const double t = (std::sqrt(squared) - near) / near;
    if (t >= 1) return 1;
    // Flat at both ends.
    return 1 + (price_.factor - 1) * (1 - t * t * (3 - 2 * t));
  }

 private:
  // From the nearest segment, or something beyond twice the distance.
  [[nodiscard]] double squared_distance_of(Vec2 p) const {
    const double near = price_.distance;
    const Vec2 reach{2 * near, 2 * near};
    Box2 box;
    box.extend(p - reach);
    box.extend(p + reach);
    thread_local std::vector<std::uint32_t> found;
    grid_.find(box, found);
    double least = 4 * near * near;
    for (const std::uint32_t i : found) {
      least = std::min(least, squared_distance(p, segments_[i].from, segments_[i].to));
      if (least <= near * near) break;
    }
    return least;
  }

  std::vector<Segment> segments_;
  LinePrice price_;
  SegmentGrid grid_;
};

}  // namespace

IrregularPrice price_near(std::vector<Segment> segments, const LinePrice& price) {
  if (segments.empty()) return {};
  const auto near = std::make_shared<const NearSegments>(std::move(segments), price);
  return [near](Vec3 p) { return near->at({p.x, p.y}); };
}

}  // namespace quarry
