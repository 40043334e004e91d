// How long the edges of elements may be where a surface has details, walls or tips that longer ones would
// bridge.
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct DetailOptions {
  // The wanted edge where there are no details, in input units.
  double edge = 1;
  // A place has details if the normals of the triangles within so many edges of it, along the surface and on
  // this side of features, do not add up to this share of their areas: 0.7 about a right-angled edge, 0.5 at
  // the end of a rounded rod, 0 where a thin wall turns back. Noise averages out.
  double reach = 0.6, least_sum = 0.6;
  // No place gets less than this share of the edge.
  double smallest = 0.125;
};

// One a vertex, in input units: the longest of edge, edge / sqrt(2), edge / 2 ... at which the place has no
// details; the smallest share where it always has, as at the tip of a cone; infinite where the edge itself
// will do. Where triangles are much smaller than the balls that are looked at, vertices within a quarter of a
// radius of one another get the same: the work is linear in the triangles for any edge.
[[nodiscard]] std::vector<double> detail_sizes(const Mesh& triangles, const ConstraintTags& tags,
                                               const DetailOptions& options, const Progress& progress);

}  // namespace quarry
