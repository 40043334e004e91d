// Puts a ring of quads around the vertex that lies opposite a straight or reflex corner: every edge at that
// vertex is cut in two, and every quad around it becomes three. The straight corner gets a second quad,
// whatever its surroundings are; so this mends what is left of forced merges, at the price of two more quads
// for each quad around the vertex, and of constrained edges being cut.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

struct RingOptions {
  // No boundary edge may be cut: vertices on the boundary then get no ring.
  bool keep_boundary = false;
};

// Tries each quad of a planar quad mesh (with ConstraintTags) that is not strictly convex, or nearly straight
// at a corner (a sine of 0.02). A ring is made if all parts of the quad are better and no more quads are not
// convex than before (exact), nor, for one that is nearly straight, as many nearly straight; what it moves
// elsewhere the next call may mend. Edges are cut in the middle, or nearer to the ringed vertex. With the
// centre of each quad on its diagonal from there, convex quads give convex quads: the parts on both sides of
// the diagonal beyond the line through the two cuts. New vertices on constrained edges slide on their piece,
// all others are free. Smooth afterwards.
PassReport ring_straight_corners(Mesh& mesh, const NodedLines& lines, const RingOptions& options,
                                 const Progress& progress);

}  // namespace quarry
