// The last step, which is always possible: the rest of a piece is put in by retriangulating what it crosses, without
// a new point.
//
// Why it always ends in a valid mesh. Let s be the segment from the front v of a piece to the first vertex exactly on
// its way to its end w (often w itself). s crosses unconstrained edges only: pieces meet at nodes alone. The triangles
// that s crosses form a region that s cuts in two polygons, each with s as one side and no vertex on s. Both are
// weakly simple (a vertex may occur twice where an edge dangles into the region), and a weakly simple polygon without
// vertices on its base always has a triangulation that uses its corners only. We pick triangles that all turn left in
// exact arithmetic; their signed areas add up to that of the polygon, so that each point of it is covered once: no
// overlap, no gap, no inverted or flat triangle. No coordinate is made, so that rounding has no say.
// Why the pass ends: every step at a front is an advance, a flip that leaves one crossed edge less, or one of at most
// max_tries refinements before the fallback; a fallback advances the front; and a split at the crossing leaves fewer
// crossed edges ahead. A piece that has used up its steps is put in by this step at once.
#pragma once

#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// Claims every vertex of the faces that the rest of the piece crosses.
void claim_crossed(const Mesh& mesh, const State& state, PieceId piece, Cavity& cavity);

// Retriangulates the faces that the rest of the piece crosses so that the front is joined to the vertex reached, which
// is returned: the end of the piece, or a vertex exactly on it. Invalid if a constrained edge or the hull is in the
// way. Among triangulations of small polygons the one with the best worst triangle is taken.
VertexId rebuild_crossed(MeshEditor& editor, const State& state, PieceId piece);

}  // namespace quarry::deferred
