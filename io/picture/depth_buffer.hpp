// What lies nearest to the eye at each pixel of a picture of a mesh in space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

class DepthBuffer {
 public:
  // For a picture of so many pixels; large ones get a coarser buffer.
  DepthBuffer(int width, int height);

  // x, y: pixels; z: the depth, greater nearer to the eye.
  void add_triangle(const std::array<Vec3, 3>& corners);

  // True unless something lies nearer to the eye, by more than the slack, at the pixel of p and at all pixels
  // beside it. What lies outside the picture is not seen.
  [[nodiscard]] bool sees(Vec3 p, double slack) const;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  double scale_ = 1;  // pixels of the buffer for one of the picture
  int width_ = 0, height_ = 0;
  std::vector<float> depth_;
};

}  // namespace quarry
