// Cuts a quad of a planar mixed mesh into two triangles.
#pragma once

#include "engine/mesh/constraint.hpp"

namespace quarry {

// A way to cut a quad: along the diagonal from one corner to the opposite one.
struct QuadCut {
  int from = 0;
  double quality = -1;  // the scaled Jacobian of the worse triangle; -1 if one does not turn left (exact)

  [[nodiscard]] bool valid() const { return quality >= 0; }
};

// The cut whose worse triangle is better; of equals that from corner 0. Not valid if neither diagonal is.
[[nodiscard]] QuadCut best_cut(const Mesh& mesh, FaceId f);

// Cuts along the diagonal from this corner, 0 or 1. The new face gets the next slot. Constraint bits are
// carried over; other tags of the new face have their initial values.
void cut_quad(Mesh& mesh, FaceId f, int from);

}  // namespace quarry
