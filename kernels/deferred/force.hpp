// The steps that end a piece whatever lies in its way: retriangulating what it crosses, towards a new point a
// few faces ahead, or, without any new point, as far as its end.
//
// Why they end in a valid mesh. Let s be the segment from the front v of a piece to a point w on its way: a
// point strictly inside a crossed face, or the first vertex exactly on the way to the end (often the end
// itself). s crosses unconstrained edges only: pieces meet at nodes alone. The triangles that s crosses form
// a region that s cuts in two polygons (or slits, where w is inside), which are weakly simple: a vertex may
// occur twice where an edge dangles into the region. A weakly simple polygon has a triangulation that uses
// its corners only. We pick triangles that all turn left in exact arithmetic; their signed areas add up to
// that of the polygon, so that each point of it is covered once: no overlap, no gap, no inverted or flat
// triangle. The sides of all corners with respect to s are tested exactly with w as it is stored. Going to
// the end makes no coordinate at all, so that rounding has no say: that step is always possible. It is taken
// only where no point a few faces ahead will do, since it makes thin triangles. Why the pass ends: every step
// at a front is an advance, a flip that leaves one crossed edge less, or one of at most max_tries refinements
// before the fallback; a fallback advances the front; and a split at the crossing leaves fewer crossed edges
// ahead. A piece that has used up a bounded number of steps takes nothing but fallbacks.
#pragma once

#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// A way to a new point of the piece, strictly inside the last of the first `faces` crossed faces.
struct Bridge {
  std::size_t faces = 0;  // none: there is no such way
  Vec2 target;
  double worst = 0;  // Lo's measure of the worst triangle that it makes
};

// The bridge with the best worst triangle among those that end in the next few faces.
[[nodiscard]] Bridge best_bridge(const Mesh& mesh, const State& state, PieceId piece);
// Claims what it touches and announces one vertex and two faces.
void claim_bridge(const Mesh& mesh, const State& state, PieceId piece, const Bridge& bridge, Cavity& cavity);
// Makes the new vertex, joined to the front, and returns it.
VertexId build_bridge(MeshEditor& editor, const State& state, PieceId piece, const Bridge& bridge,
                      NewIds ids);

// Claims every vertex of the faces that the rest of the piece crosses.
void claim_crossed(const Mesh& mesh, const State& state, PieceId piece, Cavity& cavity);

// Retriangulates the faces that the rest of the piece crosses so that the front is joined to the vertex
// reached, which is returned: the end of the piece, or a vertex exactly on it. Invalid if a constrained edge
// or the hull is in the way. Among triangulations of small polygons the one with the best worst triangle is
// taken.
VertexId rebuild_crossed(MeshEditor& editor, const State& state, PieceId piece);

}  // namespace quarry::deferred
