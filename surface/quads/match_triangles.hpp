// Quads of the triangles on a surface by matching (kernels/matching), which halves no edge that need not be.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/matching/matching.hpp"
#include "surface/feature/curve_network.hpp"

namespace quarry {

// triangles: as remesh_surface leaves them; consumed. The quads have edges as long as theirs, and are not
// smoothed: vertices in the middle of halved features, which are bound to them, and those inside of triangles
// lie on the triangles. Sheets that meet keep what they have in common as it is. Of the options those of
// what comes before and after (better_triangles, openings, rings, smoothing) are not used. No tombstones of
// faces. Throws Error(kGeometry) as edges_to_halve does. The same on any number of threads.
[[nodiscard]] Mesh match_triangles(Mesh&& triangles, const CurveNetwork& network,
                                   const MatchingOptions& options, MatchingReport& report,
                                   const Progress& progress);

}  // namespace quarry
