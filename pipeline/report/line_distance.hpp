// How far the mesh edges of each input line lie from the line.
#pragma once

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry {

// For each input line the largest distance, in input units, between it and the edges whose tag "constraint"
// bears its number, measured both ways: from the ends and middles of the edges to the line, and from the
// points of the line to the edges. The second is left out for lines that the ledger calls clipped. NaN for
// lines without edges.
[[nodiscard]] IdVector<LineId, double> measure_line_distances(const Mesh& mesh, const LineSet& lines,
                                                              const IdVector<LineId, LedgerEntry>& ledger);

}  // namespace quarry
