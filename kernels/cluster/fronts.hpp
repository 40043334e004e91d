// Alignment fronts: prepares a triangle mesh so that pairs of triangles tend to follow the constraints.
//   C. Araujo, W. Celes: Quadrilateral mesh generation with deferred constraint insertion. IMR 23, 2014,
//   section 3.2.
// The paper's loop is terse; this is our reading. On dense fracture maps it doubles the number of quads and
// lowers every mean, which is why it is an option.
#pragma once

#include <cstdint>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

struct FrontOptions {
  // How many steps a front takes away from the constraints, and one more for every other edge (by a hash of
  // its ends), which blurs the rim of the aligned zone. 0: no fronts.
  int steps = 4;
  // Edges are swapped only if both new triangles have this Lo measure.
  double min_quality = 0.1;
};

struct FrontReport {
  std::uint64_t steps = 0;
  PassReport splits{.name = "edges of fronts halved"};
  PassReport swaps{.name = "edges of fronts swapped"};
};

// In each step the edges of the front are halved and their ends labelled; the next front is
// made of
//   - the longest edges with a labelled vertex opposite;
//   - the longest edges with one labelled end and none opposite, after they have been swapped.
// "Longest" means longest of both its triangles; the first front is the constrained edges that are longest of
// one. Midpoints of constrained edges slide on their piece. All triangles turn left (exact) throughout; edges
// that cannot be halved or swapped so stay. New faces and vertices are appended. The same on any number of
// threads.
void align_fronts(Mesh& triangles, const NodedLines& lines, const FrontOptions& options, FrontReport& report,
                  const Progress& progress);

}  // namespace quarry
