#include "io/picture/depth_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quarry {
namespace {

constexpr double kLongestSide = 4000;
constexpr float kNothing = -std::numeric_limits<float>::infinity();

double doubled_area(Vec3 a, Vec3 b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

}  // namespace

DepthBuffer::DepthBuffer(int width, int height)
    : scale_(std::min(1.0, kLongestSide / std::max(width, height))),
      width_(std::max(1, static_cast<int>(width * scale_))),
      height_(std::max(1, static_cast<int>(height * scale_))),
      depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kNothing) {}

void DepthBuffer::add_triangle(const std::array<Vec3, 3>& corners) {
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
      float& depth = depth_[index(static_cast<int>(x), static_cast<int>(y))];
      depth =
          std::max(depth, static_cast<float>(weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z));
    }
  }
}

bool DepthBuffer::sees(Vec3 p, double slack) const {
  const double x = std::floor(scale_ * p.x), y = std::floor(scale_ * p.y);
  if (!(x >= 0 && x < width_ && y >= 0 && y < height_)) return false;
  float farthest = std::numeric_limits<float>::infinity();
  for (int j = std::max(0, static_cast<int>(y) - 1); j <= std::min(height_ - 1, static_cast<int>(y) + 1); ++j)
    for (int i = std::max(0, static_cast<int>(x) - 1); i <= std::min(width_ - 1, static_cast<int>(x) + 1);
         ++i)
      farthest = std::min(farthest, depth_[index(i, j)]);
  return p.z >= static_cast<double>(farthest) - slack;
}

}  // namespace quarry
