#include "io/picture/edge_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/picture/edge_style.hpp"
#include "io/picture/face_layer.hpp"

namespace quarry {
namespace {

constexpr std::size_t kEdgesInPath = 1024;

std::array<Vec2, 4> corners_of(const Mesh& mesh, FaceId f) {
  std::array<Vec2, 4> corners;
  for (int k = 0; k < mesh.corner_count(f); ++k)
    corners[static_cast<std::size_t>(k)] = mesh.point(mesh.corner(f, k));
  return corners;
}

double pixels_of_face(const PictureView& view, const Mesh& mesh, FaceId f) {
  const std::array<Vec2, 4> corners = corners_of(mesh, f);
  return pixels_of_face(view, std::span(corners).first(static_cast<std::size_t>(mesh.corner_count(f))));
}

void draw_line(Canvas& canvas, const PictureView& view, const Mesh& mesh, VertexId a, VertexId b) {
  canvas.move_to(view.to_pixels(mesh.point(a)));
  canvas.line_to(view.to_pixels(mesh.point(b)));
}

double mean_pixels(const PictureView& view, const Mesh& mesh) {
  double sum = 0;
  std::size_t count = 0;
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f)) {
      sum += pixels_of_face(view, mesh, f);
      ++count;
    }
  return sum / static_cast<double>(std::max<std::size_t>(count, 1));
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
      styles[f.value()] = static_cast<std::int8_t>(edge_style_of(pixels_of_face(view, mesh, f)));
  for (int style = 0; style < static_cast<int>(kEdgeStyles.size()); ++style) {
    const EdgeStyle& drawn = kEdgeStyles[static_cast<std::size_t>(style)];
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
  const double width = constraint_width(mean_pixels(view, mesh)) * view.unit();
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

void draw_points(Canvas& canvas, const PictureView& view, const Mesh& mesh) {
  const auto point = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  if (!point.valid()) return;
  const double radius = std::max(1.8 * constraint_width(mean_pixels(view, mesh)), 3.0) * view.unit();
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && point[v] >= 0) canvas.disc(view.to_pixels(mesh.point(v)), radius, kOutlineInk);
}

}  // namespace quarry
