#include "io/picture/face_layer.hpp"

#include <cmath>
#include <map>
#include <vector>

namespace quarry {
namespace {

// Faces are drawn together where they share one of so many steps of the scale.
constexpr int kQualitySteps = 64;
// Longer paths cost cairo more than their share.
constexpr std::size_t kFacesInPath = 1024;

class Regions {
 public:
  Regions(const Mesh& mesh, bool plain)
      : mesh_(mesh), plain_(plain), tag_(mesh.find_tag<FaceId, std::int32_t>("region")) {}

  [[nodiscard]] std::int32_t of(FaceId f) const { return plain_ || !tag_.valid() ? 0 : tag_[f]; }
  // A side with another region, or nothing, across.
  [[nodiscard]] bool is_rim(SideId s) const {
    const SideId across = mesh_.neighbour(s);
    return !across.valid() || of(across.face()) != of(s.face());
  }
  // The rim side of the same region that starts where this one ends.
  [[nodiscard]] SideId next_rim(SideId s) const {
    SideId next = mesh_.next(s);
    while (!is_rim(next)) next = mesh_.next(mesh_.neighbour(next));
    return next;
  }

 private:
  const Mesh& mesh_;
  bool plain_;
  Tag<FaceId, std::int32_t> tag_;
};

// Regions are filled by their rims: two faces side by side would show a seam.
void draw_regions(Canvas& canvas, const PictureView& view, const Mesh& mesh, bool plain) {
  const Regions regions(mesh, plain);
  std::map<std::int32_t, std::vector<SideId>> rims;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < mesh.corner_count(f); ++k)
      if (regions.is_rim(SideId(f, k))) rims[regions.of(f)].push_back(SideId(f, k));
  }
  std::vector<bool> drawn(mesh.face_slots() * 4, false);
  for (const auto& [region, sides] : rims) {
    for (const SideId first : sides) {
      if (drawn[first.value()]) continue;
      canvas.move_to(view.to_pixels(mesh.point(mesh.origin(first))));
      for (SideId s = first; !drawn[s.value()]; s = regions.next_rim(s)) {
        drawn[s.value()] = true;
        canvas.line_to(view.to_pixels(mesh.point(mesh.target(s))));
      }
      canvas.close();
    }
    canvas.fill(plain ? Colour{0.955, 0.955, 0.945} : region_colour(region));
  }
}

int step_of(double quality) {
  if (!(quality > 0)) return 0;
  return 1 + std::min(static_cast<int>(quality * kQualitySteps), kQualitySteps - 1);
}

Colour colour_of_step(int step) { return quality_colour(step == 0 ? 0.0 : (step - 0.5) / kQualitySteps); }

void fill_faces(Canvas& canvas, Colour colour) {
  // A drawing that is scaled later keeps its seams closed by a thin line of the same colour; pixels need
  // none, for each is given to one face.
  if (canvas.format() == Canvas::Format::kSvg) {
    cairo_set_source_rgb(canvas.context(), colour.red, colour.green, colour.blue);
    cairo_fill_preserve(canvas.context());
    canvas.stroke(colour, 1.0, 0.5);
  } else {
    canvas.fill(colour);
  }
}

void draw_qualities(Canvas& canvas, const PictureView& view, const Mesh& mesh,
                    std::span<const double> quality) {
  std::vector<std::vector<FaceId>> steps(kQualitySteps + 1);
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f) && shows_face(view, mesh, f))
      steps[static_cast<std::size_t>(step_of(quality[f.value()]))].push_back(f);
  cairo_set_antialias(canvas.context(), CAIRO_ANTIALIAS_NONE);
  // Good faces first: a bad face that is smaller than a pixel is not painted over.
  for (int step = kQualitySteps; step >= 0; --step) {
    std::size_t in_path = 0;
    for (const FaceId f : steps[static_cast<std::size_t>(step)]) {
      canvas.move_to(view.to_pixels(mesh.point(mesh.corner(f, 0))));
      for (int k = 1; k < mesh.corner_count(f); ++k)
        canvas.line_to(view.to_pixels(mesh.point(mesh.corner(f, k))));
      canvas.close();
      if (++in_path % kFacesInPath == 0) fill_faces(canvas, colour_of_step(step));
    }
    fill_faces(canvas, colour_of_step(step));
  }
  cairo_set_antialias(canvas.context(), CAIRO_ANTIALIAS_DEFAULT);
}

}  // namespace

bool shows_face(const PictureView& view, const Mesh& mesh, FaceId f) {
  Box2 box;
  for (int k = 0; k < mesh.corner_count(f); ++k) box.extend(view.to_pixels(mesh.point(mesh.corner(f, k))));
  const Box2& frame = view.frame();
  return box.low.x <= frame.high.x && box.high.x >= frame.low.x && box.low.y <= frame.high.y &&
         box.high.y >= frame.low.y;
}

void draw_faces(Canvas& canvas, const PictureView& view, const Mesh& mesh, const PictureOptions& options) {
  if (options.colours == PictureColours::kQuality)
    draw_qualities(canvas, view, mesh, options.quality);
  else
    draw_regions(canvas, view, mesh, options.colours == PictureColours::kConstraint);
}

}  // namespace quarry
