#include "io/picture/legend.hpp"

#include <cmath>

#include <fmt/format.h>

namespace quarry {
namespace {

constexpr Colour kInk{0.16, 0.19, 0.24};

enum class Align { kLeft, kCenter, kRight };

class LegendWriter {
 public:
  LegendWriter(Canvas& canvas, const PictureView& view) : canvas_(canvas), view_(view) {
    cairo_select_font_face(canvas.context(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(canvas.context(), 20 * view.unit());
  }

  // The base line of the letters is at p.
  void write(const std::string& text, Vec2 p, Align align) {
    cairo_text_extents_t extents;
    cairo_text_extents(canvas_.context(), text.c_str(), &extents);
    const double share = align == Align::kLeft ? 0.0 : align == Align::kCenter ? 0.5 : 1.0;
    cairo_set_source_rgb(canvas_.context(), kInk.red, kInk.green, kInk.blue);
    cairo_move_to(canvas_.context(), p.x - share * extents.x_advance, p.y);
    cairo_show_text(canvas_.context(), text.c_str());
  }

  void write_scale() {
    const double length = round_length(0.18 * view_.drawing().width() / view_.scale());
    const double pixels = length * view_.scale();
    const Vec2 left{view_.margin(), baseline()};
    const double tick = 7 * view_.unit();
    canvas_.move_to({left.x, left.y - tick});
    canvas_.line_to(left);
    canvas_.line_to({left.x + pixels, left.y});
    canvas_.line_to({left.x + pixels, left.y - tick});
    canvas_.stroke(kInk, 1.0, 2 * view_.unit());
    write(fmt::format("{:g}", length), {left.x + pixels / 2, left.y - 12 * view_.unit()}, Align::kCenter);
  }

  void write_counts(const Mesh& mesh, bool part) {
    std::size_t triangles = 0, quads = 0;
    for (const FaceId f : mesh.faces())
      if (mesh.alive(f)) ++(mesh.corner_count(f) == 4 ? quads : triangles);
    std::string text = part ? "part of " : "";
    if (quads > 0) text += grouped_digits(quads) + (quads == 1 ? " quad" : " quads");
    if (quads > 0 && triangles > 0) text += ", ";
    if (triangles > 0) text += grouped_digits(triangles) + (triangles == 1 ? " triangle" : " triangles");
    write(text, {view_.width() - view_.margin(), baseline()}, Align::kRight);
  }

  void write_quality(const std::string& name) {
    const double long_side = 420 * view_.unit();
    const double thick = 14 * view_.unit();
    const Vec2 corner{(view_.width() - long_side) / 2, baseline() - 40 * view_.unit()};
    cairo_pattern_t* pattern = cairo_pattern_create_linear(corner.x, 0, corner.x + long_side, 0);
    constexpr int kStops = 50;
    for (int i = 0; i <= kStops; ++i) {
      const double at = static_cast<double>(i) / kStops;
      const Colour colour = quality_colour(std::max(at, 1e-9));
      cairo_pattern_add_color_stop_rgb(pattern, at, colour.red, colour.green, colour.blue);
    }
    cairo_rectangle(canvas_.context(), corner.x, corner.y, long_side, thick);
    cairo_set_source(canvas_.context(), pattern);
    cairo_fill(canvas_.context());
    cairo_pattern_destroy(pattern);
    for (int i = 0; i <= 5; ++i)
      write(fmt::format("{:g}", 0.2 * i), {corner.x + 0.2 * i * long_side, baseline()}, Align::kCenter);
    write(name, {corner.x - 16 * view_.unit(), corner.y + thick}, Align::kRight);
  }

 private:
  [[nodiscard]] double baseline() const { return view_.height() - 32 * view_.unit(); }

  Canvas& canvas_;
  const PictureView& view_;
};

}  // namespace

double round_length(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit) return factor * power;
  return power;
}

std::string grouped_digits(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ',';
    grouped += digits[i];
  }
  return grouped;
}

void draw_legend(Canvas& canvas, const PictureView& view, const Mesh& mesh, const PictureOptions& options) {
  LegendWriter legend(canvas, view);
  legend.write_scale();
  legend.write_counts(mesh, options.window || options.around);
  if (options.colours == PictureColours::kQuality) legend.write_quality(options.quality_name);
}

}  // namespace quarry
