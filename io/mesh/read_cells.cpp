#include "io/mesh/read_cells.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {
namespace {

void check_points(const std::string& path, const ReadCells& cells) {
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    if (!std::isfinite(cells.x[i]) || !std::isfinite(cells.y[i]) || !std::isfinite(cells.z[i]))
      throw Error(ErrorKind::kInput,
                  fmt::format("{}: point {} has a coordinate that is not a finite number: ({}, {}, {})", path,
                              i, cells.x[i], cells.y[i], cells.z[i]));
}

Mesh build(const std::string& path, ReadCells& cells) {
  const bool planar = std::all_of(cells.z.begin(), cells.z.end(), [](double z) { return z == 0; });
  try {
    return planar ? build_mesh(std::move(cells.x), std::move(cells.y), cells.faces)
                  : build_mesh(std::move(cells.x), std::move(cells.y), std::move(cells.z), cells.faces);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", path, error.message()));
  }
}

}  // namespace

Mesh make_mesh(const std::string& path, ReadCells cells) {
  check_points(path, cells);
  Mesh mesh = build(path, cells);
  mesh.add_tag<FaceId, std::int32_t>("region").values().raw() = std::move(cells.regions);
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const auto [a, b] = cells.edges[i];
    if (std::max(a, b).value() >= mesh.vertex_slots())
      throw Error(ErrorKind::kInput, fmt::format("{}: line {} names a point that does not exist", path, i));
    if (mesh.alive(a) && mesh.alive(b)) constraint[mesh.add_edge(a, b)] = cells.constraints[i];
  }
  std::vector<std::int32_t> kinds;
  const MeshFileTags found(mesh);
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const auto [a, b] = cells.edges[i];
    if (!mesh.alive(a) || !mesh.alive(b)) continue;
    kinds.push_back(cells.kinds.empty() ? found.kind(EdgeId(kinds.size())) : cells.kinds[i]);
  }
  mesh.add_tag<EdgeId, std::int32_t>("kind").values().raw() = std::move(kinds);
  return mesh;
}

}  // namespace quarry
