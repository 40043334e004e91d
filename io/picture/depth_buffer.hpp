// What lies nearest to the eye at each pixel of a picture of a mesh in space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

class DepthBuffer {
 public:
  // For a picture of so many pixels; large ones get a coarser buffer.
  DepthBuffer(int width, int height);

  // x, y: pixels; z: the depth, greater nearer to the eye. item: what the triangle belongs to.
  void add_triangle(const std::array<Vec3, 3>& corners, std::uint32_t item);

  static constexpr std::uint32_t kNoItem = 0xffffffff;
  // Calls visit(item, nearer) for each pixel that the triangle covers: what lies nearest to the eye there,
  // and by how much it is nearer than the triangle.
  template <class Visit>
  void for_each_pixel(const std::array<Vec3, 3>& corners, Visit&& visit) const {
    for_each_covered(corners, [&](std::size_t i, double depth) {
      visit(item_[i], static_cast<double>(depth_[i]) - depth);
    });
  }

  // True unless something lies nearer to the eye, by more than the slack, at the pixel of p and at all pixels
  // beside it. What lies outside the picture is not seen.
  [[nodiscard]] bool sees(Vec3 p, double slack) const;

 private:
  // Calls visit(index, depth) for each pixel of the buffer whose centre the triangle covers.
  template <class Visit>
  void for_each_covered(const std::array<Vec3, 3>& corners, Visit&& visit) const;
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  double scale_ = 1;  // pixels of the buffer for one of the picture
  int width_ = 0, height_ = 0;
  std::vector<float> depth_;
  std::vector<std::uint32_t> item_;
};

template <class Visit>
void DepthBuffer::for_each_covered(const std::array<Vec3, 3>& corners, Visit&& visit) const {
  const auto doubled_area = [](Vec3 a, Vec3 b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  std::array<Vec3, 3> p = corners;
  for (Vec3& q : p) q = {scale_ * q.x, scale_ * q.y, q.z};
  const double area = doubled_area(p[0], p[1], p[2].x, p[2].y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto first = [](double low) { return std::max(0.0, std::ceil(low - 0.5)); };
  const auto last = [](double high, int count) { return std::min(count - 1.0, std::floor(high - 0.5)); };
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  for (double y = first(top); y <= last(bottom, height_); ++y) {
    for (double x = first(left); x <= last(right, width_); ++x) {
      std::array<double, 3> weight;
      for (std::size_t k = 0; k < 3; ++k)
        weight[k] = doubled_area(p[(k + 1) % 3], p[(k + 2) % 3], x + 0.5, y + 0.5) / area;
      if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0) continue;
      visit(index(static_cast<int>(x), static_cast<int>(y)),
            weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z);
    }
  }
}

}  // namespace quarry
