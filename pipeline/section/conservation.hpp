// The books of a job on lines: what went in is what came out, or is named.
#pragma once

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry {

// Throws Error(kBug) with the number of the line if one has no fate, if one that was dropped has no reason or
// still has a piece, if one that was not has none, or if a point has neither a node nor a reason.
void require_all_told(const LineSet& lines, const CleanedLines& cleaned);

// mesh: finished, with the edge tag "constraint". Throws Error(kBug) with the number of the line if the edges
// of a line are not as long as the pieces that bear its number.
void require_lines_kept(const Mesh& mesh, const CleanedLines& cleaned);

}  // namespace quarry
