#include "kernels/cleanup/balance.hpp"

#include <fmt/format.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/model_face.hpp"

namespace quarry {

template <GeometryModel Model>
MeshBalance balance_of(const Mesh& mesh, const Model& model) {
  const auto add = [](MeshBalance a, MeshBalance b) {
    return MeshBalance{a.charge + b.charge, a.boundary_sides + b.boundary_sides, a.triangles + b.triangles,
                       a.invalid_faces + b.invalid_faces};
  };
  const MeshBalance faces = parallel::reduce_ordered(
      mesh.face_slots(), MeshBalance{},
      [&](std::size_t begin, std::size_t end) {
        MeshBalance sum;
        for (std::size_t i = begin; i < end; ++i) {
          const FaceId f(i);
          if (!mesh.alive(f)) continue;
          const int count = mesh.corner_count(f);
          // Each face takes one from each of its corners.
          sum.charge -= count;
          if (count == 3) ++sum.triangles;
          for (int k = 0; k < count; ++k) sum.boundary_sides += mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
          sum.invalid_faces += signed_scaled_jacobian(mesh, model, f) > 0 ? 0 : 1;
        }
        sum.charge += static_cast<std::int64_t>(sum.triangles);
        return sum;
      },
      add);
  const MeshBalance vertices = parallel::reduce_ordered(
      mesh.vertex_slots(), MeshBalance{},
      [&](std::size_t begin, std::size_t end) {
        MeshBalance sum;
        for (std::size_t i = begin; i < end; ++i)
          if (mesh.alive(VertexId(i))) sum.charge += mesh.on_boundary(VertexId(i)) ? 2 : 4;
        return sum;
      },
      add);
  return add(faces, vertices);
}

template <GeometryModel Model>
std::string find_imbalance(const Mesh& mesh, const Model& model, const MeshBalance& before) {
  std::string broken = validate(mesh, GeometryCheck::kNone);
  if (!broken.empty()) return broken;
  const MeshBalance now = balance_of(mesh, model);
  if (now.charge != before.charge)
    return fmt::format("the charge was {} and is {}", before.charge, now.charge);
  if (now.boundary_sides != before.boundary_sides)
    return fmt::format("there were {} boundary sides and are {}", before.boundary_sides, now.boundary_sides);
  if ((now.triangles + now.boundary_sides) % 2 != 0)
    return fmt::format("{} triangles and {} boundary sides", now.triangles, now.boundary_sides);
  if (now.invalid_faces > before.invalid_faces)
    return fmt::format("{} faces were not valid and {} are not", before.invalid_faces, now.invalid_faces);
  return {};
}

template MeshBalance balance_of(const Mesh&, const PlaneModel&);
template MeshBalance balance_of(const Mesh&, const SpaceModel&);
template std::string find_imbalance(const Mesh&, const PlaneModel&, const MeshBalance&);
template std::string find_imbalance(const Mesh&, const SpaceModel&, const MeshBalance&);

}  // namespace quarry
