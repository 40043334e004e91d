// Where a chain of feature edges has a corner that a mesh must keep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "surface/feature/options.hpp"

namespace quarry {

enum class ChainEnds : std::uint8_t {
  kNodes,   // both ends are nodes, perhaps the same one
  kClosed,  // a closed course without a node: the last point is the first
};

// Numbers of points of a chain, ascending; never ends that are nodes. The turn at a point is the angle
// between the chords from one `size` before it along the chain and to one behind it (of a chain without a
// scale: its two edges), so that teeth of a ragged rim are no corners. The strongest turns win; where a
// corner lies nearer than `size` along the chain to a stronger one, or to a node, it is one only if it
// turns as much between chords no longer than that, and a straight way past it would miss it by a tenth of
// `size`. With a straightness in the options: every bend.
[[nodiscard]] std::vector<std::uint32_t> find_corners(std::span<const Vec3> chain, ChainEnds ends,
                                                      const FeatureOptions& options);

}  // namespace quarry
