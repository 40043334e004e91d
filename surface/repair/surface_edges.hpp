// The edges of a triangulated surface, each with all triangles that have it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

enum class EdgeUse : std::uint8_t {
  kRim,     // of one triangle
  kInner,   // of two that agree on which side is up
  kSeam,    // of two that do not: a one-sided surface is cut there
  kBranch,  // of three or more
};

// Side k of triangle t, from its corner k to the next, has the number 3 t + k.
class SurfaceEdges {
 public:
  explicit SurfaceEdges(const TriangleSurface& surface);

  [[nodiscard]] std::size_t count() const { return begin_.size() - 1; }
  // The sides on an edge, ascending.
  [[nodiscard]] std::span<const std::uint32_t> sides(std::size_t edge) const {
    return std::span(sides_).subspan(begin_[edge], begin_[edge + 1] - begin_[edge]);
  }
  [[nodiscard]] EdgeUse use_of(const TriangleSurface& surface, std::size_t edge) const {
    const auto on = sides(edge);
    if (on.size() != 2) return on.size() == 1 ? EdgeUse::kRim : EdgeUse::kBranch;
    return ends(surface, on[0]).first == ends(surface, on[1]).first ? EdgeUse::kSeam : EdgeUse::kInner;
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
