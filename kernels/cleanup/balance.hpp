// What no operation of clean-up may change, for debug builds to assert.
#pragma once

#include <cstdint>
#include <string>

#include "engine/geometry/model.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct MeshBalance {
  // Sum over inner vertices of 4 - faces, and over boundary vertices of 2 - faces, plus triangles: four times
  // the Euler characteristic (Gauss-Bonnet).
  std::int64_t charge = 0;
  std::uint64_t boundary_sides = 0;
  std::uint64_t triangles = 0;      // as odd as the boundary sides
  std::uint64_t invalid_faces = 0;  // with a corner that does not turn left
};

template <GeometryModel Model>
[[nodiscard]] MeshBalance balance_of(const Mesh& mesh, const Model& model);

// Empty if the mesh is whole and the balance is kept since `before`, with no more invalid faces; else one
// sentence.
template <GeometryModel Model>
[[nodiscard]] std::string find_imbalance(const Mesh& mesh, const Model& model, const MeshBalance& before);

extern template MeshBalance balance_of(const Mesh&, const PlaneModel&);
extern template MeshBalance balance_of(const Mesh&, const SpaceModel&);
extern template std::string find_imbalance(const Mesh&, const PlaneModel&, const MeshBalance&);
extern template std::string find_imbalance(const Mesh&, const SpaceModel&, const MeshBalance&);

}  // namespace quarry
