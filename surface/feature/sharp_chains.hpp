// Which sharp edges are features, and which are noise.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"

namespace quarry {

struct SharpEdge {
  std::array<std::uint32_t, 2> ends;  // points
  bool strong;                        // sharp by itself; else only where a chain goes on
};

// Keeps connected edges that have a strong one among them and a length of at least `shortest` all together,
// and cuts off their loose ends (to a point with one edge that is not bound to another feature) as long as
// these are shorter than half of it. What hangs at other features by both ends stays, however short. Order is
// kept.
[[nodiscard]] std::vector<SharpEdge> keep_long_chains(std::span<const Vec3> points,
                                                      std::vector<SharpEdge> edges,
                                                      std::span<const std::uint8_t> bound, double shortest);

}  // namespace quarry
