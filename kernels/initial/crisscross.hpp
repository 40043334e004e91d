// The 4-8 (crisscross, tetrakis) lattice: square cells cut by the diagonal that joins their two vertices of
// even i + j. All triangles are right and isosceles; pairing them by longest edge gives the cells back (Velho
// 2000; Araujo & Celes 2014, section 3.1.1).
#pragma once

#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct CrisscrossOptions {
  double cell = 1;           // wanted side of a cell, in the units of the box
  double angle_degrees = 0;  // the lattice is turned by this, counter-clockwise
};

// A lattice that covers the box and at least one ring of cells more, so that whatever lies in the box is away
// from the hull of the lattice. Not turned, its lines run along the sides of the box exactly: the box
// measures a whole number of cells, whose two sides are the nearest to the wanted one. Faces and vertices are
// in rows. Vertices bear no tag.
[[nodiscard]] Mesh make_crisscross(const Box2& box, const CrisscrossOptions& options);

}  // namespace quarry
