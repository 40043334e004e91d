// What no operation may change of a mesh of triangles and quads, for debug builds to assert.
#pragma once

#include <cstdint>
#include <string>

#include "engine/mesh/mesh.hpp"
#include "engine/mesh/validate.hpp"

namespace quarry {

struct MeshBalance {
  // Sum over inner vertices of 4 - faces, and over boundary vertices of 2 - faces, plus triangles: four times
  // the Euler characteristic (Gauss-Bonnet), where no two boundaries meet in a vertex.
  std::int64_t charge = 0;
  std::uint64_t boundary_sides = 0;
  std::uint64_t triangles = 0;  // as odd as the boundary sides
};

[[nodiscard]] MeshBalance balance_of(const Mesh& mesh);

// Empty if the mesh is whole, has the charge that it had, and as odd a number of triangles as of boundary
// sides (which mutual neighbours imply); else one sentence.
[[nodiscard]] std::string find_imbalance(const Mesh& mesh, const MeshBalance& before,
                                         GeometryCheck geometry = GeometryCheck::kNone);

// Asserts the same after each step of what makes or changes a mesh. Nothing in release builds.
class BalanceGuard {
 public:
#ifdef NDEBUG
  explicit BalanceGuard(const Mesh& /*before*/) {}
  void check(const char* /*step*/, const Mesh& /*mesh*/, GeometryCheck /*geometry*/) const {}
#else
  explicit BalanceGuard(const Mesh& before) : before_(balance_of(before)) {}
  void check(const char* step, const Mesh& mesh, GeometryCheck geometry) const;

 private:
  MeshBalance before_;
#endif
};

}  // namespace quarry
