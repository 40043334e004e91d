#include "io/mesh/read_cells.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {
namespace {

Mesh build(const std::string& path, ReadCells& cells) {
  const bool planar = std::all_of(cells.z.begin(), cells.z.end(), [](double z) { return z == 0; });
  try {
    return planar ? build_mesh(std::move(cells.x), std::move(cells.y), cells.faces)
                  : build_sheets(std::move(cells.x), std::move(cells.y), std::move(cells.z), cells.faces);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", path, error.message()));
  }
}

// The edges between vertices that belong to faces, in the order of the file: their places in cells.edges.
std::vector<std::size_t> add_edges(const std::string& path, const ReadCells& cells, Mesh& mesh) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const auto [a, b] = cells.edges[i];
    if (std::max(a, b).value() >= mesh.vertex_slots())
      throw Error(ErrorKind::kInput, fmt::format("{}: line {} names a point that does not exist", path, i));
    if (!mesh.alive(a) || !mesh.alive(b)) continue;
    mesh.add_edge(a, b);
    places.push_back(i);
  }
  return places;
}

// values: one for each edge of the file; none: what edges have that are added later.
template <class T>
void tag_edges(Mesh& mesh, const std::string& name, const std::vector<std::size_t>& places,
               const std::vector<T>& values, T none) {
  auto tag = mesh.add_tag<EdgeId, T>(name, none);
  for (std::size_t i = 0; i < places.size(); ++i) tag[EdgeId(i)] = values[places[i]];
}

void tag_kinds(Mesh& mesh, const std::vector<std::size_t>& places, const ReadCells& cells) {
  if (!cells.kinds.empty()) return tag_edges(mesh, "kind", places, cells.kinds, 0);
  std::vector<std::int32_t> kinds;
  const MeshFileTags found(mesh);
  for (std::size_t i = 0; i < places.size(); ++i) kinds.push_back(found.kind(EdgeId(i)));
  mesh.add_tag<EdgeId, std::int32_t>("kind").values().raw() = std::move(kinds);
}

void tag_points(Mesh& mesh, const ReadCells& cells) {
  if (cells.points.empty()) return;
  auto tag = mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1);
  for (std::size_t i = 0; i < cells.points.size(); ++i) {
    const VertexId v = cells.points[i];
    const std::int32_t number = cells.point_numbers[i];
    if (mesh.alive(v) && (tag[v] < 0 || number < tag[v])) tag[v] = number;
  }
}

}  // namespace

Mesh make_mesh(const std::string& path, ReadCells cells) {
  Mesh mesh = build(path, cells);
  mesh.add_tag<FaceId, std::int32_t>("region").values().raw() = std::move(cells.regions);
  const std::vector<std::size_t> places = add_edges(path, cells, mesh);
  tag_edges(mesh, "constraint", places, cells.constraints, -1);
  tag_kinds(mesh, places, cells);
  for (ReadGrouping& group : cells.groups) {
    if (!group.of_edges.empty()) tag_edges(mesh, group.grouping.tag, places, group.of_edges, -1);
    if (!group.of_faces.empty())
      mesh.add_tag<FaceId, std::int32_t>(group.grouping.tag).values().raw() = std::move(group.of_faces);
  }
  if (!cells.apertures.empty()) tag_edges(mesh, kApertureTag, places, cells.apertures, std::nan(""));
  tag_points(mesh, cells);
  return mesh;
}

std::vector<Grouping> groupings_of(const ReadCells& cells) {
  std::vector<Grouping> groupings;
  for (const ReadGrouping& group : cells.groups) groupings.push_back(group.grouping);
  return groupings;
}

}  // namespace quarry
