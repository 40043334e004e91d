// Axis-parallel boxes of the plane and of space. A new one is empty and holds nothing.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct Box2 {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void extend(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.y - low.y; }
  [[nodiscard]] double longer_side() const { return std::max(width(), height()); }
  [[nodiscard]] Vec2 center() const { return midpoint(low, high); }
  [[nodiscard]] bool contains(Vec2 p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  [[nodiscard]] Box2 grown(double by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
};

struct Box3 {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  void extend(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  [[nodiscard]] double longest_side() const {
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }
};

}  // namespace quarry
