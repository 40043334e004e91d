#include "surface/repair/sheets.hpp"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"
#include "surface/repair/fans.hpp"

namespace quarry {

Mesh make_sheets(const RepairedSurface& repaired) {
  const TriangleSurface& surface = repaired.surface;
  constexpr std::uint32_t kNone = 0xffffffffU;
  Fans fans(surface, SurfaceEdges(surface));
  std::vector<std::uint32_t> vertex_of_fan(3 * surface.triangles.size(), kNone);
  std::vector<std::uint8_t> taken(surface.points.size(), 0);
  std::vector<std::uint32_t> points(surface.points.size());
  std::iota(points.begin(), points.end(), 0U);
  std::vector<FaceCorners> faces(surface.triangles.size());
  for (std::uint32_t corner = 0; corner < vertex_of_fan.size(); ++corner) {
    const std::uint32_t point = surface.triangles[corner / 3][corner % 3];
    std::uint32_t& vertex = vertex_of_fan[fans.of(corner)];
    if (vertex == kNone) {
      vertex = taken[point] == 0 ? point : static_cast<std::uint32_t>(points.size());
      if (taken[point] != 0) points.push_back(point);
      taken[point] = 1;
    }
    faces[corner / 3][corner % 3] = VertexId(vertex);
  }
  std::vector<double> x, y, z;
  for (const std::uint32_t p : points) {
    x.push_back(surface.points[p].x);
    y.push_back(surface.points[p].y);
    z.push_back(surface.points[p].z);
  }
  Mesh mesh = build_mesh(std::move(x), std::move(y), std::move(z), faces);
  auto point_of = mesh.add_tag<VertexId, std::uint32_t>(kSurfacePointTag);
  for (std::size_t v = 0; v < points.size(); ++v) point_of[VertexId(v)] = points[v];
  auto group_of = mesh.add_tag<FaceId, std::int32_t>(kSurfaceGroupTag);
  for (std::size_t f = 0; f < faces.size(); ++f) group_of[FaceId(f)] = surface.groups[f];
  return mesh;
}

}  // namespace quarry
