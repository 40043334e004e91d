// Boost's maximum matchings on the dual graph of a triangle mesh, as peers; only where Boost is at hand.
#pragma once

#include <cstdint>

#include "engine/mesh/mesh.hpp"

namespace quarry::bench {

struct PeerMatching {
  double seconds = 0;             // of the processor, making the graph left out
  double mean = 0, smallest = 1;  // scaled Jacobian of the merged quads
  std::uint64_t pairs = 0;
};

// As many pairs as there can be. The mesh has ConstraintTags.
[[nodiscard]] PeerMatching boost_cardinality_matching(const Mesh& mesh);
// The largest sum of shapes, where any pair is worth more than none.
[[nodiscard]] PeerMatching boost_weighted_matching(const Mesh& mesh);

}  // namespace quarry::bench
