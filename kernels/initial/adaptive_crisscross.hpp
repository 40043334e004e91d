// The 4-8 mesh refined by a size field: a coarse crisscross lattice whose triangles are halved at their
// longest edge, and their neighbours with them, so that the mesh stays conforming and all triangles stay
// right and isosceles.
//   L. Velho, D. Zorin: 4-8 subdivision. Computer Aided Geometric Design 18 (2001).
//   E. Kossaczky: A recursive approach to local mesh refinement. J. Comput. Appl. Math. 55 (1994): why it
//   ends.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

struct AdaptiveCrisscrossOptions {
  double coarsest = 1;       // side of the cells of the start lattice, in the units of the box
  double finest = 0.001;     // no leg is halved that is not longer than this; keeps the work bounded
  double angle_degrees = 0;  // the lattice is turned by this, counter-clockwise
};

// Covers the box and a margin, as make_crisscross with cells of the coarsest size does. The legs of a
// triangle that comes near the box are at most 1.19 of the size wanted at its longest edge (or as coarse as
// the start), and shorter than 0.84 of it only as far as neighbours ask for. In Hilbert order; no tags.
// Throws Error(kInput) with the place if the field is not positive somewhere. report: if given, what the pass
// of halvings did.
[[nodiscard]] Mesh make_adaptive_crisscross(const Box2& box, const SizeField& field,
                                            const AdaptiveCrisscrossOptions& options,
                                            const Progress& progress, PassReport* report = nullptr);

}  // namespace quarry
