// Checks the invariants of the mesh store and names the relation that is broken.
#pragma once

#include <string>

#include "engine/mesh/mesh.hpp"

namespace quarry {

enum class GeometryCheck {
  kNone,           // connectivity only
  kPlanarCorners,  // each corner of each face turns left, exactly
};

// Empty if all holds; else one sentence that names the first broken relation (by entity number) with the
// entities and their places. Checked: corners distinct and alive; neighbours mutual and over the same two
// vertices; side_of starts at its vertex and is the most clockwise one on the boundary; every corner of a
// vertex is met in one turn around it (no two fans at one vertex); edges join vertices that are alive.
[[nodiscard]] std::string validate(const Mesh& mesh, GeometryCheck geometry);

// True if every corner of the face turns left (exact): the validity of a face in the plane.
[[nodiscard]] bool all_corners_turn_left(const Mesh& mesh, FaceId face);

}  // namespace quarry
