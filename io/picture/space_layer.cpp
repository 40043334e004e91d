#include "io/picture/space_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "io/picture/camera.hpp"
#include "io/picture/depth_buffer.hpp"
#include "io/picture/edge_style.hpp"
#include "io/picture/paint_order.hpp"

namespace quarry {
namespace {

// How many pixels a line may lie behind what covers it: it lies between the faces beside it.
constexpr double kLineSlack = 2.5;
// In pixels: what lies nearer by no more is as near.
constexpr double kSameDepth = 0.05;

Colour mixed(Colour a, Colour b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

// Light from over the left shoulder, some of it from everywhere. The back of a surface is greyer.
Colour shaded(Colour colour, Vec3 normal) {
  const double size = length(normal);
  if (!(size > 0)) return colour;
  constexpr Vec3 kLight{-0.36, 0.48, 0.80};
  const Colour base = normal.z < 0 ? mixed(colour, {0.52, 0.50, 0.47}, 0.6) : colour;
  const double cosine = std::max(0.0, dot(kLight, normal) * (normal.z < 0 ? -1 : 1) / size);
  const double light = 0.50 + 0.56 * cosine;
  return {std::min(1.0, light * base.red), std::min(1.0, light * base.green),
          std::min(1.0, light * base.blue)};
}

class SpaceDrawing {
 public:
  SpaceDrawing(Canvas& canvas, const PictureView& view, const SeenMesh& seen, const PictureOptions& options)
      : canvas_(canvas),
        view_(view),
        seen_(seen),
        mesh_(seen.mesh),
        options_(options),
        region_(mesh_.find_tag<FaceId, std::int32_t>("region")),
        depth_(view.width(), view.height()) {}

  void run() {
    for (const FaceId f : seen_.faces)
      for_each_triangle(f,
                        [&](const std::array<Vec3, 3>& corners) { depth_.add_triangle(corners, f.value()); });
    find_order();
    for (const FaceId f : order_) {
      draw_face(f);
      draw_edges(f);
    }
    draw_lines();
  }

 private:
  [[nodiscard]] Vec3 pixel(VertexId v) const { return pixel(seen_.points[v.value()]); }
  // Depth in pixels too.
  [[nodiscard]] Vec3 pixel(Vec3 p) const {
    const Vec2 q = view_.to_pixels({p.x, p.y});
    return {q.x, q.y, view_.scale() * p.z};
  }

  template <class Visit>
  void for_each_triangle(FaceId f, Visit&& visit) const {
    for (int k = 1; k + 1 < mesh_.corner_count(f); ++k)
      visit({pixel(mesh_.corner(f, 0)), pixel(mesh_.corner(f, k)), pixel(mesh_.corner(f, k + 1))});
  }

  // The faces of which something is seen, those that others cover first.
  void find_order() {
    std::vector<FaceId> faces;
    std::vector<double> depths;
    rank_.assign(mesh_.face_slots(), -1);
    for (const FaceId f : seen_.faces) {
      const Vec3 middle = middle_of(f);
      if (!shows(f, middle)) continue;
      rank_[f.value()] = static_cast<std::int64_t>(faces.size());
      faces.push_back(f);
      depths.push_back(middle.z);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> covered;
    for (std::uint32_t i = 0; i < faces.size(); ++i)
      for_each_triangle(faces[i], [&](const std::array<Vec3, 3>& corners) {
        depth_.for_each_pixel(corners, [&](std::uint32_t nearest, double nearer) {
          if (nearer <= kSameDepth || nearest == faces[i].value() || rank_[nearest] < 0) return;
          const std::pair pair(i, static_cast<std::uint32_t>(rank_[nearest]));
          if (covered.empty() || covered.back() != pair) covered.push_back(pair);
        });
      });
    for (const std::uint32_t i : paint_order(depths, std::move(covered))) {
      rank_[faces[i].value()] = static_cast<std::int64_t>(order_.size());
      order_.push_back(faces[i]);
    }
  }

  [[nodiscard]] Vec3 middle_of(FaceId f) const {
    Vec3 sum;
    const int count = mesh_.corner_count(f);
    for (int k = 0; k < count; ++k) sum = sum + pixel(mesh_.corner(f, k));
    return (1.0 / count) * sum;
  }

  // At one of its pixels; a face smaller than a pixel at its middle.
  [[nodiscard]] bool shows(FaceId f, Vec3 middle) const {
    bool covers = false, shows = false;
    for_each_triangle(f, [&](const std::array<Vec3, 3>& corners) {
      depth_.for_each_pixel(corners, [&](std::uint32_t, double nearer) {
        covers = true;
        shows = shows || nearer <= kSameDepth;
      });
    });
    return covers ? shows : depth_.sees(middle, 1);
  }

  [[nodiscard]] Colour colour_of(FaceId f) const {
    switch (options_.colours) {
      case PictureColours::kQuality:
        return quality_colour(options_.quality[f.value()]);
      case PictureColours::kConstraint:
        return {0.955, 0.955, 0.945};
      case PictureColours::kRegion:
        break;
    }
    return region_colour(region_.valid() ? region_[f] : 0);
  }

  [[nodiscard]] std::array<Vec2, 4> outline_of(FaceId f) const {
    std::array<Vec2, 4> corners;
    for (int k = 0; k < mesh_.corner_count(f); ++k) {
      const Vec3 p = seen_.points[mesh_.corner(f, k).value()];
      corners[static_cast<std::size_t>(k)] = {p.x, p.y};
    }
    return corners;
  }

  // A thin line of the same colour closes the seams between faces.
  void draw_face(FaceId f) {
    const auto at = [&](int k) { return seen_.points[mesh_.corner(f, k).value()]; };
    const int count = mesh_.corner_count(f);
    const Vec3 normal =
        count == 3 ? cross(at(1) - at(0), at(2) - at(0)) : cross(at(2) - at(0), at(3) - at(1));
    const Colour colour = shaded(colour_of(f), normal);
    const auto outline = outline_of(f);
    canvas_.move_to(view_.to_pixels(outline[0]));
    for (int k = 1; k < count; ++k) canvas_.line_to(view_.to_pixels(outline[static_cast<std::size_t>(k)]));
    canvas_.close();
    cairo_set_source_rgb(canvas_.context(), colour.red, colour.green, colour.blue);
    cairo_fill_preserve(canvas_.context());
    canvas_.stroke(colour, 1.0, 0.6);
  }

  // Each edge with the nearer one of its faces, which would paint over half of it.
  void draw_edges(FaceId f) {
    const auto outline = outline_of(f);
    const auto corners = std::span(outline).first(static_cast<std::size_t>(mesh_.corner_count(f)));
    const int style = edge_style_of(pixels_of_face(view_, corners));
    if (style < 0) return;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const SideId across = mesh_.neighbour(SideId(f, static_cast<int>(k)));
      if (across.valid() && rank_[across.face().value()] > rank_[f.value()]) continue;
      canvas_.move_to(view_.to_pixels(corners[k]));
      canvas_.line_to(view_.to_pixels(corners[(k + 1) % corners.size()]));
    }
    const EdgeStyle& drawn = kEdgeStyles[static_cast<std::size_t>(style)];
    canvas_.stroke(kElementInk, drawn.opacity, drawn.width * view_.unit());
  }

  // Features by the edge tag "constraint", and rims.
  void draw_lines() {
    double pixels = 0;
    for (const FaceId f : order_) {
      const auto outline = outline_of(f);
      pixels +=
          pixels_of_face(view_, std::span(outline).first(static_cast<std::size_t>(mesh_.corner_count(f))));
    }
    const double width =
        constraint_width(pixels / static_cast<double>(std::max<std::size_t>(order_.size(), 1))) *
        view_.unit();
    const auto constraint = mesh_.find_tag<EdgeId, std::int32_t>("constraint");
    for (const EdgeId e : mesh_.edges()) {
      const auto [a, b] = mesh_.edge_ends(e);
      if (!shown(a) || !shown(b)) continue;
      const bool by_line = options_.colours == PictureColours::kConstraint && constraint.valid();
      draw_visible(a, b, by_line ? line_colour(constraint[e]) : kConstraintInk, width);
    }
    for (const FaceId f : seen_.faces) {
      for (int k = 0; k < mesh_.corner_count(f); ++k) {
        const SideId s(f, k);
        if (!mesh_.neighbour(s).valid())
          draw_visible(mesh_.origin(s), mesh_.target(s), kOutlineInk, 1.25 * width);
      }
    }
  }

  [[nodiscard]] bool shown(VertexId v) const {
    if (!options_.around) return true;
    return length(mesh_.point3(v) - options_.around->center) <= options_.around->radius;
  }

  // The parts of the line that are seen, to a pixel.
  void draw_visible(VertexId a, VertexId b, Colour colour, double width) {
    const Vec3 p = pixel(a), q = pixel(b);
    const double pixels = length(Vec2{q.x - p.x, q.y - p.y});
    const int steps = static_cast<int>(std::clamp(std::ceil(pixels), 1.0, 10000.0));
    const auto at = [&](double step) { return p + (step / steps) * (q - p); };
    int begin = -1;
    for (int i = 0; i <= steps; ++i) {
      const bool visible = i < steps && depth_.sees(at(i + 0.5), kLineSlack * view_.unit());
      if (visible && begin < 0) begin = i;
      if (visible || begin < 0) continue;
      canvas_.move_to({at(begin).x, at(begin).y});
      canvas_.line_to({at(i).x, at(i).y});
      begin = -1;
    }
    canvas_.stroke(colour, 1.0, width);
  }

  Canvas& canvas_;
  const PictureView& view_;
  const SeenMesh& seen_;
  const Mesh& mesh_;
  const PictureOptions& options_;
  Tag<FaceId, std::int32_t> region_;
  DepthBuffer depth_;
  std::vector<FaceId> order_;
  std::vector<std::int64_t> rank_;  // by face, in the order; -1: not seen
};

}  // namespace

SeenMesh see_mesh(const Mesh& mesh, const PictureOptions& options) {
  SeenMesh seen{mesh, std::vector<Vec3>(mesh.vertex_slots()), {}, {}};
  const Camera camera(options.view);
  // From a place nearby, so that large coordinates keep their digits.
  const Vec3 origin = options.around ? options.around->center : mesh.box3().low;
  parallel::for_each(mesh.vertex_slots(),
                     [&](std::size_t i) { seen.points[i] = camera.seen(mesh.point3(VertexId(i)) - origin); });
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    bool near = true;
    for (int k = 0; k < mesh.corner_count(f) && options.around; ++k)
      near = near && length(mesh.point3(mesh.corner(f, k)) - origin) <= options.around->radius;
    if (!near) continue;
    seen.faces.push_back(f);
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const Vec3 p = seen.points[mesh.corner(f, k).value()];
      seen.box.extend({p.x, p.y});
    }
  }
  return seen;
}

void draw_in_space(Canvas& canvas, const PictureView& view, const SeenMesh& seen,
                   const PictureOptions& options) {
  SpaceDrawing(canvas, view, seen, options).run();
}

}  // namespace quarry
