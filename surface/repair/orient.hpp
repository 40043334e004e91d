// Neighbouring triangles agree on which side is up.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/repair/surface_edges.hpp"

namespace quarry {

struct Orientation {
  std::vector<std::uint8_t> turn;  // one a triangle, 1: its corners are to be taken the other way round
  std::vector<std::uint32_t>
      conflicts;  // edges of two triangles that cannot agree: cuts of a one-sided surface
};

// Goes from triangle to triangle over edges of exactly two. In each part that hangs together so, the smaller
// number of triangles is turned, of equals those unlike the first.
[[nodiscard]] Orientation orient(const TriangleSurface& surface, const SurfaceEdges& edges);

}  // namespace quarry
