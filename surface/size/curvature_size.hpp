// How long the edges of elements may be where a surface is curved.
#pragma once

#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct CurvatureOptions {
  // How far the middle of an edge may lie from the surface: a chord of length h lies h^2 / (8 r) from a
  // circle of radius r.
  double error = 0;
  // The wanted edge where the surface is flat; no place gets less than the given share of it.
  double edge = 1, smallest = 1.0 / 32;
};

// One a vertex, in input units; infinite where the edge itself will do. The curvature is the largest along
// the edges of the triangles at a vertex: the turn of the normals, which features split, by the length.
[[nodiscard]] std::vector<double> curvature_sizes(const Mesh& triangles, const ConstraintTags& tags,
                                                  const CurvatureOptions& options);

}  // namespace quarry
