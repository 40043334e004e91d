// The rim of a convex patch cut into sides, under one of two rules for what a corner is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/cleanup/patch_growth.hpp"
#include "kernels/cleanup/patch_ring.hpp"

namespace quarry {

enum class CornerRule : std::uint8_t {
  kOuterAngle,  // corners turn by the outer angle: rim vertices become regular where they can (Bunin)
  kInnerFaces,  // corners have one face inside: rim vertices keep their own number of faces (Jaal)
};

inline constexpr std::size_t kMostSides = 6;

struct PatchSides {
  // Corners by either rule; only the first kMostSides are kept below. Fewer than 3 or more than 6 have no
  // fill.
  std::uint32_t count = 0;
  std::array<std::uint32_t, kMostSides> corners{};  // places on the rim, ascending
  std::array<std::uint32_t, kMostSides> lengths{};  // edges of the side from a corner to the next

  [[nodiscard]] std::span<const std::uint32_t> corner_places() const {
    return std::span(corners).first(count);
  }
  [[nodiscard]] std::span<const std::uint32_t> side_lengths() const {
    return std::span(lengths).first(count);
  }
  friend bool operator==(const PatchSides&, const PatchSides&) = default;
};

// rim: as PatchGrowth::walk_rim gives it.
[[nodiscard]] PatchSides find_sides(const PatchGrowth& growth, std::span<const VertexId> rim,
                                    CornerRule rule);

// The same of a ring without reflex vertices.
[[nodiscard]] PatchSides find_sides(const PatchRing& ring);

}  // namespace quarry
