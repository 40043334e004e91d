// The mean over all faces, for tests that lift it.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/face.hpp"

namespace quarry::test {

inline double mean_scaled_jacobian(const Mesh& mesh) {
  double sum = 0;
  for (const FaceId f : mesh.faces()) sum += scaled_jacobian(mesh, f);
  return sum / static_cast<double>(mesh.face_slots());
}

}  // namespace quarry::test
