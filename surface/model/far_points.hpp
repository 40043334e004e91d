// How far a mesh lies from the points of its surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

struct NearestFace {
  FaceId face;          // none: no face looks the same way
  double distance = 0;  // in input units
};

// Of each of some free points of the surface (numbers in its free_points()) the nearest face of the mesh, of
// triangles or quads, that is on the same side of the surface (kSameSide).
[[nodiscard]] std::vector<NearestFace> find_nearest_faces(const Mesh& mesh, const SurfaceModel& model,
                                                          std::span<const std::uint32_t> points);

// The edge of the square that is as large as a face, in input units.
[[nodiscard]] double edge_of_square(const Mesh& mesh, FaceId f);

// The free points of the surface that are farther from the mesh than `far` times the edge of the square as
// large as the face nearest to them: the farthest of all first, and of points within `apart` (input units) of
// one another the farthest alone.
[[nodiscard]] std::vector<Vec3> find_lost_places(const Mesh& mesh, const SurfaceModel& model, double far,
                                                 double apart);

}  // namespace quarry
