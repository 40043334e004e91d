// The faces of a mesh on a picture, as coloured areas.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/picture.hpp"
#include "io/picture/view.hpp"

namespace quarry {

void draw_faces(Canvas& canvas, const PictureView& view, const Mesh& mesh, const PictureOptions& options);

// True unless all of the face lies outside the shown part.
[[nodiscard]] bool shows_face(const PictureView& view, const Mesh& mesh, FaceId f);

}  // namespace quarry
