// Sweeps over a whole planar mesh that bring its quads near to rectangles of the wanted size and its
// triangles near to equilateral ones.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/smooth/shape_star.hpp"
#include "kernels/smooth/sweep.hpp"

namespace quarry {

struct ShapeOptions {
  int sweeps = 10;
  // The wanted edge by place, up to a factor: the faces are to share the area that there is in proportion to
  // its square. None: each face is to be as large as those around it are at the start.
  const SizeField* size = nullptr;
  // More weight for the size than the default makes areas more even and angles less square. Between changes
  // of the topology Stretch::kOfQuad keeps regions in better order; at the end Stretch::kOfCorner makes more
  // right angles and more even areas at once, but a few more corners below 30 degrees.
  ShapeTarget target{.size_weight = 0.3, .largest_aspect = 6};
  // Stars whose faces all have at least this scaled Jacobian, and areas within this factor of the wanted one,
  // are left alone until a neighbour moves.
  double content = 0.98;
  double content_areas = 1.6;
  // Faces may lose scaled Jacobian for others' sake down to this, and never below.
  double floor = 0.3;
  // The same for the longest edge by the shortest, of quads.
  double largest_edge_ratio = 6;
  // How far to go along each Newton step: beyond 1, as in successive over-relaxation, long waves of error die
  // sooner. Steps are for fixed aspects, which the energy follows: hence more than 2 here.
  double relaxation = 2.2;
  // A vertex that would move by less than this share of the edges at it stays where it is.
  double tolerance = 0.005;
};

// One Newton step a vertex and sweep on the energy of kernels/smooth/shape_star.hpp, whole or half or a
// quarter of it. A move is accepted only if the energy falls, no corner of the star that turns left is turned
// over (exact), and the limits of the options hold. Stars with a corner that is turned over are untangled by
// the regularised energy where that can be done one vertex at a time. Sliding vertices step along their
// piece; vertices that may not move keep their bits.
SweepReport optimise_shape(Mesh& mesh, const NodedLines& lines, const ShapeOptions& options,
                           const Progress& progress);

}  // namespace quarry
