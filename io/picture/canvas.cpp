#include "io/picture/canvas.hpp"

#include <algorithm>
#include <string_view>

#include <cairo-svg.h>
#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

// cairo holds coordinates as 24.8 fixed-point numbers: what lies far outside the picture is drawn less far
// outside.
constexpr double kFarthest = 1e6;

cairo_status_t append_bytes(void* target, const unsigned char* data, unsigned int size) noexcept {
  try {
    static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

// cairo numbers the surfaces of a process and writes the number: it is taken out, so that a picture has the
// same bytes wherever it is drawn.
void remove_surface_number(std::string& svg) {
  constexpr std::string_view kPlace = "id=\"surface";
  const std::size_t found = svg.find(kPlace);
  if (found == std::string::npos) return;
  const std::size_t begin = found + kPlace.size();
  svg.erase(begin, svg.find('"', begin) - begin);
}

}  // namespace

Canvas::Canvas(Format format, int width, int height) : format_(format) {
  if (format == Format::kSvg) {
    surface_ = cairo_svg_surface_create_for_stream(append_bytes, &bytes_, width, height);
    cairo_svg_surface_set_document_unit(surface_, CAIRO_SVG_UNIT_PX);
  } else {
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  }
  context_ = cairo_create(surface_);
  cairo_set_source_rgb(context_, 1, 1, 1);
  cairo_paint(context_);
  cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
}

void Canvas::require_success(cairo_status_t status) const {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::kOutput,
                fmt::format("the picture cannot be drawn: {}", cairo_status_to_string(status)));
}

std::string Canvas::take_bytes() {
  require_success(cairo_status(context_));
  if (format_ == Format::kPng)
    require_success(cairo_surface_write_to_png_stream(surface_, append_bytes, &bytes_));
  else
    cairo_surface_finish(surface_);
  require_success(cairo_surface_status(surface_));
  if (format_ == Format::kSvg) remove_surface_number(bytes_);
  return std::move(bytes_);
}

void Canvas::move_to(Vec2 p) {
  cairo_move_to(context_, std::clamp(p.x, -kFarthest, kFarthest), std::clamp(p.y, -kFarthest, kFarthest));
}

void Canvas::line_to(Vec2 p) {
  cairo_line_to(context_, std::clamp(p.x, -kFarthest, kFarthest), std::clamp(p.y, -kFarthest, kFarthest));
}

void Canvas::fill(Colour colour) {
  cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue);
  cairo_fill(context_);
}

void Canvas::stroke(Colour colour, double opacity, double width) {
  cairo_set_source_rgba(context_, colour.red, colour.green, colour.blue, opacity);
  cairo_set_line_width(context_, width);
  cairo_stroke(context_);
}

void Canvas::disc(Vec2 centre, double radius, Colour colour) {
  move_to(centre);
  line_to(centre);
  stroke(colour, 1.0, 2 * radius);
}

}  // namespace quarry
