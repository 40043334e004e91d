// The edges of a mesh on a picture: those of its elements, thin, and its constraints and outline, strong.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/picture.hpp"
#include "io/picture/view.hpp"

namespace quarry {

// Element edges are the paler the smaller the elements are, and vanish where they could not be told apart: a
// fine mesh is not a black one.
void draw_element_edges(Canvas& canvas, const PictureView& view, const Mesh& mesh);

// By the edge tags "constraint" and "kind"; sides without a face across are drawn as outline in any case.
void draw_constraints(Canvas& canvas, const PictureView& view, const Mesh& mesh,
                      const PictureOptions& options);

// Dots at the points of the input, where the mesh has kPointTag.
void draw_points(Canvas& canvas, const PictureView& view, const Mesh& mesh);

}  // namespace quarry
