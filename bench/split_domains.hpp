// Quads to clean up: Delaunay triangulations of simple domains with each triangle split in three quads, which
// leaves half of the inner vertices irregular. All boundary vertices are fixed.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/mesh/mesh.hpp"

namespace quarry::bench {

enum class SplitDomain : std::uint8_t {
  kDisk,
  kSquare,   // opposite sides have the same number of edges
  kAnnulus,  // and here both circles
  kLShape,   // and here each long side has as many as the two sides across
};
// disk, square, annulus, l-shape; none of any other word.
[[nodiscard]] std::optional<SplitDomain> split_domain_of(std::string_view name);

// About so many quads.
[[nodiscard]] Mesh split_quads(SplitDomain domain, double quads, std::uint64_t seed);

}  // namespace quarry::bench
