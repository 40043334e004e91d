// Halves every edge of a mesh of triangles and quads: a quad becomes four quads, a triangle three. An
// all-quad mesh, whatever the input.
#pragma once

#include <cstdint>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"

namespace quarry {

struct SubdivideReport {
  std::uint64_t quads = 0;
  std::uint64_t from_triangles =
      0;  // triangles of the coarse mesh, each of which makes a vertex of three faces
  std::uint64_t undone_merges = 0;  // quads cut in two again because rounding left no valid subdivision
};

// Every face of the result is valid (exact). Vertices: those of the coarse mesh with their numbers, then
// midpoints of edges by face, then centres of faces; so each group lies in the coarse mesh's spatial order.
// Quads follow the order of the coarse faces; each starts at its coarse vertex. The midpoint of a constrained
// edge slides on its piece and is constructed as a point of it; the midpoint of any other edge with one face
// is fixed. Tombstones vanish (faces) or stay (vertices). Throws Error(kGeometry) with the place where a
// coarse triangle is too flat for valid quads in double precision.
[[nodiscard]] Mesh subdivide(Mesh&& coarse, const NodedLines& lines, SubdivideReport& report,
                             const Progress& progress);

// The same in space, where only topology is certain: new vertices lie in the straight middle of their edges
// and faces, those on constraints with the support of an end that slides, or fixed between ends that do not.
// To be put on the surface, and judged, by the caller.
[[nodiscard]] Mesh subdivide_in_space(Mesh&& coarse, SubdivideReport& report);

}  // namespace quarry
