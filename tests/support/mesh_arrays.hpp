// All that a mesh holds of points and connectivity, for comparing meshes bit by bit.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry::test {

inline std::vector<std::uint64_t> arrays_of(const Mesh& mesh) {
  std::vector<std::uint64_t> all;
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.point3(v);
    for (const double value : {p.x, p.y, p.z}) all.push_back(std::bit_cast<std::uint64_t>(value));
    all.push_back(mesh.side_of(v).value());
  }
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 4; ++k) {
      all.push_back(mesh.corner(f, k).value());
      all.push_back(mesh.neighbour(SideId(f, k)).value());
    }
  }
  return all;
}

}  // namespace quarry::test
