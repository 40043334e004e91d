// A mesh in space on a picture: its faces shaded, hidden ones left out, edges, features and rims on top.
#pragma once

#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/picture.hpp"
#include "io/picture/view.hpp"

namespace quarry {

// A mesh as the camera of the options sees it.
struct SeenMesh {
  const Mesh& mesh;
  std::vector<Vec3> points;   // by vertex; to the right, upwards, towards the eye
  std::vector<FaceId> faces;  // those that are shown: all, or those around a place
  Box2 box;                   // of their points
};

[[nodiscard]] SeenMesh see_mesh(const Mesh& mesh, const PictureOptions& options);

// Faces are painted from the farthest to the nearest, by their middles: where one is many times as large as
// another that it passes, the order may be wrong. Lines are cut where something lies before them, to a pixel.
void draw_in_space(Canvas& canvas, const PictureView& view, const SeenMesh& seen,
                   const PictureOptions& options);

}  // namespace quarry
