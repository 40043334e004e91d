#include "kernels/cleanup/balance.hpp"

#include <fmt/format.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/model_face.hpp"

namespace quarry {

template <GeometryModel Model>
ModelBalance balance_of(const Mesh& mesh, const Model& model) {
  const auto invalid = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    return mesh.alive(FaceId(i)) && !(signed_scaled_jacobian(mesh, model, FaceId(i)) > 0);
  });
  return {balance_of(mesh), invalid.size()};
}

template <GeometryModel Model>
std::string find_imbalance(const Mesh& mesh, const Model& model, const ModelBalance& before) {
  std::string broken = find_imbalance(mesh, before.mesh);
  if (!broken.empty()) return broken;
  const ModelBalance now = balance_of(mesh, model);
  if (now.mesh.boundary_sides != before.mesh.boundary_sides)
    return fmt::format("there were {} boundary sides and are {}", before.mesh.boundary_sides,
                       now.mesh.boundary_sides);
  if (now.invalid_faces > before.invalid_faces)
    return fmt::format("{} faces were not valid and {} are not", before.invalid_faces, now.invalid_faces);
  return {};
}

template ModelBalance balance_of(const Mesh&, const PlaneModel&);
template ModelBalance balance_of(const Mesh&, const SpaceModel&);
template std::string find_imbalance(const Mesh&, const PlaneModel&, const ModelBalance&);
template std::string find_imbalance(const Mesh&, const SpaceModel&, const ModelBalance&);

}  // namespace quarry
