#include "io/picture/depth_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quarry {
namespace {

constexpr double kLongestSide = 4000;
constexpr float kNothing = -std::numeric_limits<float>::infinity();

}  // namespace

DepthBuffer::DepthBuffer(int width, int height)
    : scale_(std::min(1.0, kLongestSide / std::max(width, height))),
      width_(std::max(1, static_cast<int>(width * scale_))),
      height_(std::max(1, static_cast<int>(height * scale_))),
      depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kNothing),
      item_(depth_.size(), kNoItem) {}

void DepthBuffer::add_triangle(const std::array<Vec3, 3>& corners, std::uint32_t item) {
  for_each_covered(corners, [&](std::size_t i, double depth) {
    if (static_cast<float>(depth) <= depth_[i]) return;
    depth_[i] = static_cast<float>(depth);
    item_[i] = item;
  });
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
