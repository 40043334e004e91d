// Points that come, go and move, found by nearness: a hash of square cells.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/line_set.hpp"

namespace quarry::linework {

class NodeBuckets {
 public:
  // radius: of nearest(), in the units of the points.
  NodeBuckets(Vec2 origin, double radius) : origin_(origin), radius_(radius) {}

  void insert(NodeId node, Vec2 at) {
    if (next_.size() <= node.value()) {
      next_.resize(node.value() + 1);
      points_.resize(node.value() + 1);
    }
    points_[node.value()] = at;
    NodeId& head = heads_[key(column(at.x - origin_.x), column(at.y - origin_.y))];
    next_[node.value()] = head;
    head = node;
  }

  void remove(NodeId node) {
    const Vec2 at = points_[node.value()];
    NodeId* link = &heads_[key(column(at.x - origin_.x), column(at.y - origin_.y))];
    while (*link != node) link = &next_[link->value()];
    *link = next_[node.value()];
  }

  // The node nearest to p among those nearer than the radius, the smallest of equals; `except` does not
  // count.
  [[nodiscard]] NodeId nearest(Vec2 p, NodeId except = {}) const {
    NodeId best;
    double best_distance = radius_ * radius_;
    const std::int64_t c = column(p.x - origin_.x);
    const std::int64_t r = column(p.y - origin_.y);
    for (std::int64_t i = c - 1; i <= c + 1; ++i) {
      for (std::int64_t j = r - 1; j <= r + 1; ++j) {
        const auto cell = heads_.find(key(i, j));
        if (cell == heads_.end()) continue;
        for (NodeId n = cell->second; n.valid(); n = next_[n.value()]) {
          const double d = squared_length(points_[n.value()] - p);
          if (n == except || d > best_distance || (d == best_distance && !(best.valid() && n < best)))
            continue;
          best = n;
          best_distance = d;
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::int64_t column(double offset) const {
    return static_cast<std::int64_t>(std::floor(offset / radius_));
  }
  // Cells that share a key cost time, nothing else: distances decide.
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return mix64(static_cast<std::uint64_t>(column)) ^ static_cast<std::uint64_t>(row);
  }

  Vec2 origin_;
  double radius_;
  std::unordered_map<std::uint64_t, NodeId> heads_;
  std::vector<NodeId> next_;
  std::vector<Vec2> points_;
};

}  // namespace quarry::linework
