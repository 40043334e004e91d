// What no operation of clean-up may change, for debug builds to assert: the balance of the mesh, its
// boundary, and that faces are valid on the model.
#pragma once

#include <cstdint>
#include <string>

#include "engine/geometry/model.hpp"
#include "engine/mesh/balance.hpp"

namespace quarry {

struct ModelBalance {
  MeshBalance mesh;
  std::uint64_t invalid_faces = 0;  // with a corner that does not turn left
};

template <GeometryModel Model>
[[nodiscard]] ModelBalance balance_of(const Mesh& mesh, const Model& model);

// Empty if the mesh is whole and the balance is kept since `before`, with as many boundary sides and no more
// invalid faces; else one sentence.
template <GeometryModel Model>
[[nodiscard]] std::string find_imbalance(const Mesh& mesh, const Model& model, const ModelBalance& before);

extern template ModelBalance balance_of(const Mesh&, const PlaneModel&);
extern template ModelBalance balance_of(const Mesh&, const SpaceModel&);
extern template std::string find_imbalance(const Mesh&, const PlaneModel&, const ModelBalance&);
extern template std::string find_imbalance(const Mesh&, const SpaceModel&, const ModelBalance&);

}  // namespace quarry
