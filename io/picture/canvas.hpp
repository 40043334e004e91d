// A drawing surface of cairo that becomes the bytes of a .png or .svg file.
#pragma once

#include <span>
#include <string>

#include <cairo.h>

#include "engine/geometry/vec.hpp"
#include "io/picture/colour.hpp"

namespace quarry {

class Canvas {
 public:
  enum class Format { kPng, kSvg };

  // White, of the given size in pixels.
  Canvas(Format format, int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Finishes the drawing; nothing may be drawn afterwards.
  [[nodiscard]] std::string take_bytes();

  [[nodiscard]] Format format() const { return format_; }
  [[nodiscard]] cairo_t* context() { return context_; }

  // Adds to the path.
  void move_to(Vec2 p);
  void line_to(Vec2 p);
  void close() { cairo_close_path(context_); }
  // Fills the path or strokes it with round ends, and forgets it.
  void fill(Colour colour);
  void stroke(Colour colour, double opacity, double width);
  void disc(Vec2 centre, double radius, Colour colour);

 private:
  void require_success(cairo_status_t status) const;

  Format format_;
  std::string bytes_;
  cairo_surface_t* surface_ = nullptr;
  cairo_t* context_ = nullptr;
};

}  // namespace quarry
