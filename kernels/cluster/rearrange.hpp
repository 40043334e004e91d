// Recuts small patches of a mixed mesh, so that fewer single triangles and fewer irregular vertices are left.
// Greedy pairing strands triangles a few faces apart; each becomes a vertex of three faces when the mesh is
// halved, and by the balance of charge (sum over inner vertices of 4 - faces = 4 X - triangles) calls for
// another irregular vertex.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

struct RearrangeOptions {
  // New faces need this smallest corner sine, or that of the worst face of the patch where it was worse
  // already.
  double min_sine = 0.2;
  // What a corner sine of 0 in place of 1 costs, in irregular vertices.
  double shape_weight = 1.0;
  // What a corner sine costs beyond that for each unit that it lies below flat_sine. A wide angle between two
  // lines that one face fills alone cannot be smoothed away.
  double flat_sine = 0.25;
  double flat_weight = 64.0;
  // Patches of up to so many faces are looked at.
  int most_faces = 2;
  // Two triangles are joined across chains of up to so many quads.
  int longest_chain = 3;
};

// Lowers, patch by patch, the cost
//   triangles + sum over vertices of a growing function of |faces - wanted faces| + sum over faces of a
//   falling function of the sine of the worst corner (times an aspect factor)
// where 4 faces are wanted inside and one a right angle, rounded, on the rim. Vertices neither move nor come
// or go; constrained sides stay. All new faces turn left (exact). Faces that are left over become tombstones.
// Runs as a pass: the same result on any number of threads. It ends because each step lowers the cost.
PassReport rearrange(Mesh& mixed, const RearrangeOptions& options, const Progress& progress);

}  // namespace quarry
