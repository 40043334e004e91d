// Cuts a quad of a planar mixed mesh into two triangles.
#pragma once

#include "engine/mesh/constraint.hpp"

namespace quarry {

// Cuts along the diagonal whose worse triangle is better by Lo's measure, if both turn left (exact); the new
// face gets the next slot. Constraint bits are carried over. False, and nothing is changed, if neither
// diagonal is valid.
bool cut_quad(Mesh& mesh, FaceId f);

}  // namespace quarry
