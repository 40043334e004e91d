// Where everything lies on the picture: the part of the plane that is shown, and the strip below it for the
// scale.
#pragma once

#include <algorithm>

#include "engine/geometry/box.hpp"

namespace quarry {

class PictureView {
 public:
  // Fits the box into the width, less tall than kTallest times as wide.
  PictureView(const Box2& shown, int width) : width_(width), unit_(width / 1600.0) {
    const double wide = shown.width();
    const double tall = shown.height();
    const double room = width - 2 * margin();
    scale_ = std::min(wide > 0 ? room / wide : kUnbounded, tall > 0 ? kTallest * room / tall : kUnbounded);
    center_ = shown.center();
    drawing_.low = {margin(), margin()};
    drawing_.high = {width - margin(), margin() + scale_ * tall};
    frame_.low = to_pixels({shown.low.x, shown.high.y});
    frame_.high = to_pixels({shown.high.x, shown.low.y});
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return static_cast<int>(drawing_.high.y + footer() + 0.5); }
  // Pixels for one unit of the coordinates.
  [[nodiscard]] double scale() const { return scale_; }
  // Pixels for one pixel of a picture of 1600.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double margin() const { return 40 * unit_; }
  [[nodiscard]] double footer() const { return 96 * unit_; }
  // The room for the drawing, and the part of it that the shown box takes.
  [[nodiscard]] const Box2& drawing() const { return drawing_; }
  [[nodiscard]] const Box2& frame() const { return frame_; }

  // y points down on the picture.
  [[nodiscard]] Vec2 to_pixels(Vec2 p) const {
    const Vec2 middle = drawing_.center();
    return {middle.x + scale_ * (p.x - center_.x), middle.y - scale_ * (p.y - center_.y)};
  }

 private:
  static constexpr double kTallest = 1.5;
  static constexpr double kUnbounded = 1e300;

  int width_;
  double unit_;
  double scale_ = 1;
  Vec2 center_;
  Box2 drawing_;
  Box2 frame_;
};

}  // namespace quarry
