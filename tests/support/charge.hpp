// The charge of a mesh of triangles and quads: sum over interior vertices of 4 - faces, plus sum over
// boundary vertices of 2 - faces, plus the number of triangles. It is four times the Euler characteristic
// (Gauss-Bonnet).
#pragma once

#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry::test {

inline int charge_of(const Mesh& mesh) {
  std::vector<int> faces(mesh.vertex_slots(), 0);
  int charge = 0;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    if (mesh.corner_count(f) == 3) ++charge;
    for (int k = 0; k < mesh.corner_count(f); ++k) ++faces[mesh.corner(f, k).value()];
  }
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v)) charge += (mesh.on_boundary(v) ? 2 : 4) - faces[v.value()];
  return charge;
}

}  // namespace quarry::test
