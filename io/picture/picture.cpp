#include "io/picture/picture.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/lower_case.hpp"
#include "io/picture/edge_layer.hpp"
#include "io/picture/face_layer.hpp"
#include "io/picture/legend.hpp"
#include "io/picture/space_layer.hpp"

namespace quarry {
namespace {

constexpr int kNarrowest = 64;
constexpr int kWidest = 20000;

Canvas::Format format_of(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".png") return Canvas::Format::kPng;
  if (extension == ".svg") return Canvas::Format::kSvg;
  throw Error(
      ErrorKind::kUsage,
      fmt::format("{}: the picture format \"{}\" is not known; use one of .svg, .png", path, extension));
}

bool shows_a_face(const Mesh& mesh, const Box2& window) {
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    Box2 box;
    for (int k = 0; k < mesh.corner_count(f); ++k) box.extend(mesh.point(mesh.corner(f, k)));
    if (box.low.x < window.high.x && window.low.x < box.high.x && box.low.y < window.high.y &&
        window.low.y < box.high.y)
      return true;
  }
  return false;
}

void check(const std::string& path, const Mesh& mesh, const PictureOptions& options) {
  const auto refuse = [&](std::string_view reason) {
    throw Error(ErrorKind::kUsage, fmt::format("{}: {}", path, reason));
  };
  if (options.width < kNarrowest || options.width > kWidest)
    refuse(fmt::format("a picture is {} to {} pixels wide, not {}", kNarrowest, kWidest, options.width));
  if (mesh.count_alive_faces() == 0) refuse("a mesh without faces cannot be drawn");
  if (options.window && !mesh.planar()) refuse("a mesh in space has no window: show a part around a place");
  if (options.around && mesh.planar()) refuse("a mesh of the plane is shown in part by a window");
  if (options.around && !(options.around->radius > 0)) refuse("the radius of what is shown must be above 0");
  if (options.window && !(options.window->width() > 0 && options.window->height() > 0))
    refuse("the window of a picture needs a width and a height");
  if (options.window && !shows_a_face(mesh, *options.window)) {
    const Box2 box = mesh.box();
    refuse(fmt::format("no face lies in the window {} to {}; the mesh lies in {} to {}",
                       format_point(options.window->low.x, options.window->low.y),
                       format_point(options.window->high.x, options.window->high.y),
                       format_point(box.low.x, box.low.y), format_point(box.high.x, box.high.y)));
  }
  if (options.colours == PictureColours::kQuality && options.quality.size() != mesh.face_slots())
    throw Error(ErrorKind::kBug,
                fmt::format("{} quality values for {} faces", options.quality.size(), mesh.face_slots()));
}

// A window cuts the drawing at its frame; a whole mesh has room for its outline to be drawn thick.
void clip_to_window(Canvas& canvas, const PictureView& view) {
  const Box2& frame = view.frame();
  cairo_rectangle(canvas.context(), frame.low.x, frame.low.y, frame.width(), frame.height());
  cairo_clip(canvas.context());
}

void frame_window(Canvas& canvas, const PictureView& view) {
  const Box2& frame = view.frame();
  cairo_rectangle(canvas.context(), frame.low.x, frame.low.y, frame.width(), frame.height());
  canvas.stroke({0.45, 0.48, 0.53}, 1.0, 1.5 * view.unit());
}

std::string draw_plane(Canvas::Format format, const Mesh& mesh, const PictureOptions& options,
                       const Progress& progress) {
  const PictureView view(options.window.value_or(mesh.box()), options.width);
  Canvas canvas(format, view.width(), view.height());
  cairo_save(canvas.context());
  if (options.window) clip_to_window(canvas, view);
  draw_faces(canvas, view, mesh, options);
  progress.throw_if_cancelled();
  draw_element_edges(canvas, view, mesh);
  progress.throw_if_cancelled();
  draw_constraints(canvas, view, mesh, options);
  draw_points(canvas, view, mesh);
  cairo_restore(canvas.context());
  if (options.window) frame_window(canvas, view);
  draw_legend(canvas, view, mesh, options);
  return canvas.take_bytes();
}

std::string draw_space(const std::string& path, Canvas::Format format, const Mesh& mesh,
                       const PictureOptions& options, const Progress& progress) {
  const SeenMesh seen = see_mesh(mesh, options);
  progress.throw_if_cancelled();
  if (seen.faces.empty())
    throw Error(ErrorKind::kUsage, fmt::format("{}: no face lies in the ball that is to be shown", path));
  const PictureView view(seen.box, options.width);
  Canvas canvas(format, view.width(), view.height());
  draw_in_space(canvas, view, seen, options);
  draw_legend(canvas, view, mesh, options);
  return canvas.take_bytes();
}

}  // namespace

void write_picture(const std::string& path, const Mesh& mesh, const PictureOptions& options,
                   const Progress& progress) {
  const Canvas::Format format = format_of(path);
  check(path, mesh, options);
  const std::string bytes = mesh.planar() ? draw_plane(format, mesh, options, progress)
                                          : draw_space(path, format, mesh, options, progress);
  progress.throw_if_cancelled();
  write_file(path, bytes);
}

void check_picture_extension(const std::string& path) { static_cast<void>(format_of(path)); }

}  // namespace quarry
