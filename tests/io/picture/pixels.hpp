// What tests see of a picture.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "io/picture/canvas.hpp"
#include "io/picture/colour.hpp"

namespace quarry {

// The pixels of a .png file.
class Pixels {
 public:
  explicit Pixels(const std::string& path) : surface_(cairo_image_surface_create_from_png(path.c_str())) {}
  ~Pixels() { cairo_surface_destroy(surface_); }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;

  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_); }
  [[nodiscard]] Colour at(int x, int y) const {
    const unsigned char* row =
        cairo_image_surface_get_data(surface_) + y * cairo_image_surface_get_stride(surface_);
    return {row[4 * x + 2] / 255.0, row[4 * x + 1] / 255.0, row[4 * x] / 255.0};
  }
  // At a share of width and height.
  [[nodiscard]] Colour at_share(double x, double y) const {
    return at(static_cast<int>(x * width()), static_cast<int>(y * height()));
  }

 private:
  cairo_surface_t* surface_;
};

inline void expect_colour(Colour seen, Colour wanted) {
  EXPECT_NEAR(seen.red, wanted.red, 0.004);
  EXPECT_NEAR(seen.green, wanted.green, 0.004);
  EXPECT_NEAR(seen.blue, wanted.blue, 0.004);
}

inline double lightness(Colour c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

}  // namespace quarry
