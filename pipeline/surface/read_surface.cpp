#include "pipeline/surface/read_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"

namespace quarry {
namespace {

double squared_distance(Vec3 a, Vec3 b) { return dot(b - a, b - a); }

void add_face(TriangleSurface& surface, const FaceCorners& corners, std::uint32_t base, std::int32_t group) {
  const auto point = [&](std::size_t k) { return base + corners[k].value(); };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    surface.triangles.push_back({point(a), point(b), point(c)});
    surface.groups.push_back(group);
  };
  if (!corners[3].valid()) return add(0, 1, 2);
  const auto& p = surface.points;
  const bool first = squared_distance(p[point(0)], p[point(2)]) <= squared_distance(p[point(1)], p[point(3)]);
  add(0, 1, first ? 2 : 3);
  add(first ? 0 : 1, 2, 3);
}

void require_finite(const std::string& path, const ReadCells& cells) {
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i]) || !std::isfinite(cells.z[i]))
      throw Error(ErrorKind::kInput, fmt::format("{}: point {} is not finite: ({}, {}, {})", path, i + 1,
                                                 cells.x[i], cells.y[i], cells.z[i]));
}

}  // namespace

TriangleSurface read_surface(const std::vector<std::string>& paths, GroupNames& names) {
  TriangleSurface surface;
  std::int32_t next_group = 0;
  for (const std::string& path : paths) {
    const ReadCells cells = read_cells(path);
    require_finite(path, cells);
    const auto base = static_cast<std::uint32_t>(surface.points.size());
    for (std::size_t i = 0; i < cells.x.size(); ++i)
      surface.points.push_back({cells.x[i], cells.y[i], cells.z[i]});
    const std::int32_t offset = next_group;
    for (std::size_t f = 0; f < cells.faces.size(); ++f) {
      for (const VertexId v : cells.faces[f])
        if (v.valid() && v.value() >= cells.x.size())
          throw Error(ErrorKind::kInput,
                      fmt::format("{}: face {} names a point that does not exist", path, f + 1));
      add_face(surface, cells.faces[f], base, offset + cells.regions[f]);
      next_group = std::max(next_group, offset + cells.regions[f] + 1);
    }
    for (const auto& [number, name] : cells.names.regions) names.regions[offset + number] = name;
  }
  if (surface.triangles.empty())
    throw Error(ErrorKind::kInput, fmt::format("{}: no triangle or quad to mesh", paths.front()));
  return surface;
}

}  // namespace quarry
