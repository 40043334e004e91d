// The lines of a job on a surface.
#pragma once

#include <vector>

#include "kernels/linework/clean_lines.hpp"
#include "pipeline/surface/surface.hpp"

namespace quarry {

// Cuts the lines of the result, whose size is set, into the surface, and fills its imprint report. Returns
// the edges that they go along.
[[nodiscard]] std::vector<LineEdge> imprint_input(RepairedSurface& repaired, const SurfaceOptions& options,
                                                  SurfaceResult& result);

// What became of each line.
[[nodiscard]] IdVector<LineId, LedgerEntry> ledger_of(const ImprintReport& imprint);

// The largest distance of each line's points on the surface from the edges of the mesh that it has, or shares
// with others, in input units; NaN for a line without any.
[[nodiscard]] IdVector<LineId, double> line_distances(const SurfaceResult& result);

}  // namespace quarry
