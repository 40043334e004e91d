#include "kernels/quality/face.hpp"

#include <limits>

#include "engine/parallel/parallel.hpp"

namespace quarry {

std::vector<double> scaled_jacobians(const Mesh& mesh) {
  std::vector<double> values(mesh.face_slots(), std::numeric_limits<double>::quiet_NaN());
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    if (mesh.alive(FaceId(i))) values[i] = scaled_jacobian(mesh, FaceId(i));
  });
  return values;
}

}  // namespace quarry
