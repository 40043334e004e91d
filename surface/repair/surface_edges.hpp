// The edges of a triangulated surface, each with all triangles that have it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

// Side k of triangle t, from its corner k to the next, has the number 3 t + k.
class SurfaceEdges {
 public:
  explicit SurfaceEdges(const TriangleSurface& surface);

  [[nodiscard]] std::size_t count() const { return begin_.size() - 1; }
  // The sides on an edge, ascending.
  [[nodiscard]] std::span<const std::uint32_t> sides(std::size_t edge) const {
    return std::span(sides_).subspan(begin_[edge], begin_[edge + 1] - begin_[edge]);
  }
  // The edge of a side.
  [[nodiscard]] std::uint32_t of_side(std::uint32_t side) const { return edge_of_[side]; }
  // The points of a side, from its origin on.
  [[nodiscard]] static std::pair<std::uint32_t, std::uint32_t> ends(const TriangleSurface& surface,
                                                                    std::uint32_t side) {
    const SurfaceTriangle& t = surface.triangles[side / 3];
    return {t[side % 3], t[(side + 1) % 3]};
  }

 private:
  std::vector<std::uint32_t> sides_, begin_, edge_of_;
};

}  // namespace quarry
