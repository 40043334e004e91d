// Points that come, go and move, found by nearness: a hash of square cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/geometry/segment.hpp"

namespace quarry::linework {

// Open addressing; the cells are four radii wide, so that a question concerns two of them on average, and the
// few points that lie in each if all are a radius apart.
class NodeBuckets {
 public:
  // radius: of nearest(), in the units of the points.
  NodeBuckets(Vec2 origin, double radius) : origin_(origin), radius_(radius), slots_(kFirstSlots) {}

  // Room for so many nodes, so that they are not moved again and again as they come.
  void reserve(std::size_t nodes) {
    while (slots_.size() < 2 * nodes) grow();
    next_.reserve(nodes);
    points_.reserve(nodes);
  }

  void insert(NodeId node, Vec2 at) {
    if (next_.size() <= node.value()) {
      next_.resize(node.value() + 1);
      points_.resize(node.value() + 1);
    }
    points_[node.value()] = at;
    NodeId& head = head_of(at);
    next_[node.value()] = head;
    head = node;
  }

  void remove(NodeId node) {
    NodeId* link = &head_of(points_[node.value()]);
    while (*link != node) link = &next_[link->value()];
    *link = next_[node.value()];
  }

  // Calls visit(node, place) for all nodes nearer to the segment ab than the radius, and for others, in no
  // order. Takes time for the cells along the segment or for all nodes, whichever are fewer.
  template <class Visit>
  void visit_along(Vec2 a, Vec2 b, Visit&& visit) const {
    const double side = kCellSide * radius_;
    const double cells = 3 * (std::abs(b.x - a.x) + std::abs(b.y - a.y)) / side;
    if (cells > static_cast<double>(slots_.size())) {
      for (const Slot& each : slots_) visit_chain(each.head, visit);
      return;
    }
    const auto [left, right] = std::minmax({a.x - origin_.x, b.x - origin_.x});
    const std::int64_t last_column = cell(right + radius_);
    for (std::int64_t c = cell(left - radius_); c <= last_column; ++c) {
      // What of the segment is no farther from this column than the radius.
      const double begin = static_cast<double>(c) * side - radius_;
      const double end = begin + side + 2 * radius_;
      const auto [low, high] = std::minmax({height_at(begin, a, b), height_at(end, a, b)});
      const std::int64_t last_row = cell(high + radius_);
      for (std::int64_t r = cell(low - radius_); r <= last_row; ++r)
        visit_chain(slots_[slot(key(c, r))].head, visit);
    }
  }

  // The node nearest to p among those nearer than the radius, the smallest of equals; `except` does not
  // count.
  [[nodiscard]] NodeId nearest(Vec2 p, NodeId except = {}) const {
    NodeId best;
    double best_distance = radius_ * radius_;
    const std::int64_t last_column = cell(p.x - origin_.x + radius_);
    const std::int64_t last_row = cell(p.y - origin_.y + radius_);
    for (std::int64_t c = cell(p.x - origin_.x - radius_); c <= last_column; ++c) {
      for (std::int64_t r = cell(p.y - origin_.y - radius_); r <= last_row; ++r) {
        for (NodeId n = slots_[slot(key(c, r))].head; n.valid(); n = next_[n.value()]) {
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
  struct Slot {
    std::uint64_t key = kNoKey;
    NodeId head;
  };
  static constexpr std::uint64_t kNoKey = 0;
  static constexpr std::size_t kFirstSlots = 1024;  // a power of two
  static constexpr double kCellSide = 4;            // in radii

  template <class Visit>
  void visit_chain(NodeId head, Visit&& visit) const {
    for (NodeId n = head; n.valid(); n = next_[n.value()]) visit(n, points_[n.value()]);
  }

  // Offset in y of the point of the segment ab that has this offset in x, or of its nearest end.
  [[nodiscard]] double height_at(double x, Vec2 a, Vec2 b) const {
    const double ahead = x + origin_.x - a.x;
    const double width = b.x - a.x;
    const double t = width == 0 ? (ahead < 0 ? 0.0 : 1.0) : std::clamp(ahead / width, 0.0, 1.0);
    return point_at(t, a, b).y - origin_.y;
  }

  [[nodiscard]] std::int64_t cell(double offset) const {
    return static_cast<std::int64_t>(std::floor(offset / (kCellSide * radius_)));
  }
  // Cells that share a key cost time, nothing else: distances decide.
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    const std::uint64_t mixed =
        mix64(mix64(static_cast<std::uint64_t>(column)) ^ static_cast<std::uint64_t>(row));
    return mixed == kNoKey ? 1 : mixed;
  }
  // Where a key is, or would be.
  [[nodiscard]] std::size_t slot(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = key & mask;
    while (slots_[i].key != key && slots_[i].key != kNoKey) i = (i + 1) & mask;
    return i;
  }

  NodeId& head_of(Vec2 at) {
    const std::uint64_t wanted = key(cell(at.x - origin_.x), cell(at.y - origin_.y));
    std::size_t i = slot(wanted);
    if (slots_[i].key == kNoKey) {
      if (2 * ++used_ > slots_.size()) {
        grow();
        i = slot(wanted);
      }
      slots_[i].key = wanted;
    }
    return slots_[i].head;
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& filled : old)
      if (filled.key != kNoKey) slots_[slot(filled.key)] = filled;
  }

  Vec2 origin_;
  double radius_;
  std::vector<Slot> slots_;
  std::size_t used_ = 0;
  std::vector<NodeId> next_;
  std::vector<Vec2> points_;
};

}  // namespace quarry::linework
