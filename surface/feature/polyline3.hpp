// A polyline in space that finds its own nearest point quickly.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

class Polyline3 {
 public:
  // At least two points. A closed one ends where it begins.
  explicit Polyline3(std::vector<Vec3> points);

  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  [[nodiscard]] bool closed() const { return points_.front() == points_.back(); }
  [[nodiscard]] double length() const { return length_; }
  // The nearest point of the polyline, of equally near ones the first along it. Time grows with the logarithm
  // of its points where the query is near.
  [[nodiscard]] Vec3 nearest(Vec3 p) const;

 private:
  struct Box {
    Vec3 low, high;
    [[nodiscard]] double squared_distance(Vec3 p) const;
  };
  struct Nearest {
    Vec3 point;
    double squared;
  };

  void visit(std::size_t node, std::size_t begin, std::size_t end, Vec3 p, Nearest& best) const;
  Box build(std::size_t node, std::size_t begin, std::size_t end);

  std::vector<Vec3> points_;
  std::vector<Box> boxes_;  // a binary tree over the segments, root at 1
  double length_ = 0;
};

}  // namespace quarry
