#include "io/picture/edge_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "io/picture/face_layer.hpp"

namespace quarry {
namespace {

constexpr Colour kElementInk{0.16, 0.21, 0.28};
constexpr Colour kConstraintInk{0.10, 0.13, 0.18};
constexpr Colour kOutlineInk{0.05, 0.07, 0.10};
constexpr std::size_t kEdgesInPath = 1024;

// How edges of elements of at least so many pixels are drawn.
struct EdgeStyle {
  double from_pixels;
  double opacity;
  double width;
};
constexpr std::array<EdgeStyle, 6> kStyles = {{{2.2, 0.10, 0.5},
                                               {3.2, 0.20, 0.55},
                                               {4.5, 0.30, 0.6},
                                               {7.0, 0.42, 0.7},
                                               {12.0, 0.52, 0.85},
                                               {24.0, 0.62, 1.1}}};

// The side of a square of the face's area, in pixels of a picture of 1600.
double pixels_of_face(const PictureView& view, const Mesh& mesh, FaceId f) {
  const Vec2 origin = mesh.point(mesh.corner(f, 0));
  double doubled = 0;
  for (int k = 1; k + 1 < mesh.corner_count(f); ++k)
    doubled += cross(mesh.point(mesh.corner(f, k)) - origin, mesh.point(mesh.corner(f, k + 1)) - origin);
  return std::sqrt(0.5 * std::abs(doubled)) * view.scale() / view.unit();
}

int style_of(double pixels) {
  int style = -1;
  while (style + 1 < static_cast<int>(kStyles.size()) &&
         pixels >= kStyles[static_cast<std::size_t>(style + 1)].from_pixels)
    ++style;
  return style;
}

void draw_line(Canvas& canvas, const PictureView& view, const Mesh& mesh, VertexId a, VertexId b) {
  canvas.move_to(view.to_pixels(mesh.point(a)));
  canvas.line_to(view.to_pixels(mesh.point(b)));
}

// Lines as wide as the elements leave room for.
double constraint_width(const PictureView& view, const Mesh& mesh) {
  double sum = 0;
  std::size_t count = 0;
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f)) {
      sum += pixels_of_face(view, mesh, f);
      ++count;
    }
  return std::clamp(0.25 * sum / static_cast<double>(std::max<std::size_t>(count, 1)), 1.2, 2.4);
}

void draw_outline(Canvas& canvas, const PictureView& view, const Mesh& mesh, double width) {
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      if (!mesh.neighbour(s).valid()) draw_line(canvas, view, mesh, mesh.origin(s), mesh.target(s));
    }
  }
  canvas.stroke(kOutlineInk, 1.0, width);
}

}  // namespace

void draw_element_edges(Canvas& canvas, const PictureView& view, const Mesh& mesh) {
  std::vector<std::int8_t> styles(mesh.face_slots(), -1);
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f) && shows_face(view, mesh, f))
      styles[f.value()] = static_cast<std::int8_t>(style_of(pixels_of_face(view, mesh, f)));
  for (int style = 0; style < static_cast<int>(kStyles.size()); ++style) {
    const EdgeStyle& drawn = kStyles[static_cast<std::size_t>(style)];
    std::size_t in_path = 0;
    for (const FaceId f : mesh.faces()) {
      if (styles[f.value()] != style) continue;
      for (int k = 0; k < mesh.corner_count(f); ++k) {
        // An edge between two sizes is drawn once, with the paler face.
        const SideId s(f, k);
        const SideId across = mesh.neighbour(s);
        const int other = across.valid() ? styles[across.face().value()] : style;
        if (across.valid() && (other < style || (other == style && across < s))) continue;
        draw_line(canvas, view, mesh, mesh.origin(s), mesh.target(s));
        if (++in_path % kEdgesInPath == 0)
          canvas.stroke(kElementInk, drawn.opacity, drawn.width * view.unit());
      }
    }
    canvas.stroke(kElementInk, drawn.opacity, drawn.width * view.unit());
  }
}

void draw_constraints(Canvas& canvas, const PictureView& view, const Mesh& mesh,
                      const PictureOptions& options) {
  const double width = constraint_width(view, mesh) * view.unit();
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  std::map<std::int32_t, std::vector<EdgeId>> by_line;
  for (const EdgeId e : mesh.edges())
    by_line[options.colours == PictureColours::kConstraint && constraint.valid() ? constraint[e] : -1]
        .push_back(e);
  draw_outline(canvas, view, mesh, 1.5 * width);
  for (const auto& [line, edges] : by_line) {
    for (const EdgeId e : edges) {
      const auto [a, b] = mesh.edge_ends(e);
      draw_line(canvas, view, mesh, a, b);
    }
    canvas.stroke(options.colours == PictureColours::kConstraint ? line_colour(line) : kConstraintInk, 1.0,
                  width);
  }
}

}  // namespace quarry
