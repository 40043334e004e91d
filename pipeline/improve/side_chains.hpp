// Tagged edges that several sides of faces cover in place of one.
#pragma once

#include <vector>

#include "engine/mesh/mesh.hpp"
#include "pipeline/improve/tagged_lines.hpp"

namespace quarry {

// Puts the sides of a chain in place of each tagged edge that is no side of a face itself but has a chain of
// them on it: what a program leaves that halves sides along lines without halving their line elements. All
// others stay as they are. tolerance: a vertex of a chain may lie this far from the edge, in input units, but
// at least 1e-5 and at most 1e-3 of the edge's length. The ends of the edges are alive.
[[nodiscard]] std::vector<TaggedEdge> follow_sides(const Mesh& mesh, const std::vector<TaggedEdge>& tagged,
                                                   double tolerance);

}  // namespace quarry
