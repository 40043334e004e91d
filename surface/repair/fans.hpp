// Which corners of triangles at a point hang together.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/repair/surface_edges.hpp"

namespace quarry {

// Corners at one point belong to one fan if one gets from the one to the other over edges of two triangles
// that agree on which side is up. Corner k of triangle t has the number 3 t + k.
class Fans {
 public:
  Fans(const TriangleSurface& surface, const SurfaceEdges& edges);

  // The smallest corner of the fan.
  [[nodiscard]] std::uint32_t of(std::uint32_t corner);

 private:
  void join(std::uint32_t a, std::uint32_t b);

  std::vector<std::uint32_t> root_;
};

}  // namespace quarry
