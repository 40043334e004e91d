#include "pipeline/section/start.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/initial/adaptive_crisscross.hpp"
#include "kernels/initial/crisscross.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/direction.hpp"
#include "kernels/initial/given.hpp"

namespace quarry {
namespace {

Mesh read_start(const std::string& path, const NodedLines& lines) {
  const Mesh given = read_mesh(path);
  try {
    Mesh mesh = adopt_start_mesh(given);
    require_lines_inside(mesh, lines);
    return mesh;
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", path, error.message()));
  }
}

Box2 box_of(const NodedLines& lines) {
  Box2 box;
  for (const Vec2 p : lines.nodes) box.extend(p);
  return box;
}

}  // namespace

double find_orientation(const SectionOptions& options, OutlineRule rule, const NodedLines& lines) {
  if (options.orient_degrees) return *options.orient_degrees;
  if (!options.orient_auto && rule == OutlineRule::kBox) return 0;
  return dominant_direction(lines);
}

Mesh make_start_mesh(const SectionOptions& options, const NodedLines& lines, double spacing,
                     double orient_degrees) {
  const Box2 box = box_of(lines);
  switch (options.start) {
    case StartMesh::kDelaunay:
      return make_delaunay(box, {.spacing = spacing, .angle_degrees = orient_degrees, .seed = options.seed});
    case StartMesh::kFile:
      return read_start(options.start_file, lines);
    case StartMesh::kCrisscross:
      break;
  }
  return make_crisscross(box, {.cell = spacing, .angle_degrees = orient_degrees});
}

Mesh make_graded_start(const NodedLines& lines, const SizeField& sizes, double coarsest,
                       double orient_degrees, PassReport& report, const Progress& progress) {
  return make_adaptive_crisscross(box_of(lines), sizes,
                                  {.coarsest = coarsest, .finest = 0, .angle_degrees = orient_degrees},
                                  progress, &report);
}

}  // namespace quarry
