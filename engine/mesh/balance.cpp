#include "engine/mesh/balance.hpp"

#include <cassert>

#include <fmt/format.h>

#include "engine/base/log.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

MeshBalance sum_of(MeshBalance a, MeshBalance b) {
  return {a.charge + b.charge, a.boundary_sides + b.boundary_sides, a.triangles + b.triangles};
}

// Each face takes one from each of its corners, and a triangle gives one back.
MeshBalance balance_of_faces(const Mesh& mesh, std::size_t begin, std::size_t end) {
  MeshBalance sum;
  for (std::size_t i = begin; i < end; ++i) {
    const FaceId f(i);
    if (!mesh.alive(f)) continue;
    const int count = mesh.corner_count(f);
    sum.charge -= count == 3 ? 2 : 4;
    sum.triangles += count == 3 ? 1 : 0;
    for (int k = 0; k < count; ++k) sum.boundary_sides += mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
  }
  return sum;
}

MeshBalance balance_of_vertices(const Mesh& mesh, std::size_t begin, std::size_t end) {
  MeshBalance sum;
  for (std::size_t i = begin; i < end; ++i)
    if (mesh.alive(VertexId(i))) sum.charge += mesh.on_boundary(VertexId(i)) ? 2 : 4;
  return sum;
}

}  // namespace

MeshBalance balance_of(const Mesh& mesh) {
  const MeshBalance faces = parallel::reduce_ordered(
      mesh.face_slots(), MeshBalance{},
      [&](std::size_t begin, std::size_t end) { return balance_of_faces(mesh, begin, end); }, sum_of);
  const MeshBalance vertices = parallel::reduce_ordered(
      mesh.vertex_slots(), MeshBalance{},
      [&](std::size_t begin, std::size_t end) { return balance_of_vertices(mesh, begin, end); }, sum_of);
  return sum_of(faces, vertices);
}

std::string find_imbalance(const Mesh& mesh, const MeshBalance& before, GeometryCheck geometry) {
  std::string broken = validate(mesh, geometry);
  if (!broken.empty()) return broken;
  const MeshBalance now = balance_of(mesh);
  if (now.charge != before.charge)
    return fmt::format("the charge was {} and is {}", before.charge, now.charge);
  if ((now.triangles + now.boundary_sides) % 2 != 0)
    return fmt::format("{} triangles and {} boundary sides", now.triangles, now.boundary_sides);
  return {};
}

#ifndef NDEBUG
void BalanceGuard::check(const char* step, const Mesh& mesh, GeometryCheck geometry) const {
  const std::string broken = find_imbalance(mesh, before_, geometry);
  if (!broken.empty()) log::warn("after {}: {}", step, broken);
  assert(broken.empty());
}
#endif

}  // namespace quarry
