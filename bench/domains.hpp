// Triangulations of simple domains, and the quads that clean-up is measured on: each triangle split in three,
// which leaves half of the inner vertices irregular.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/mesh/mesh.hpp"

namespace quarry::bench {

enum class Domain : std::uint8_t {
  kDisk,
  kSquare,   // opposite sides have the same number of edges
  kAnnulus,  // and here both circles
  kLShape,   // and here each long side has as many as the two sides across
};
// disk, square, annulus, l-shape; none of any other word.
[[nodiscard]] std::optional<Domain> domain_of(std::string_view name);

struct DomainPoints {
  double boundary_spacing = 1;  // of boundary points, as a share of the spacing inside
  double jitter = 0.25;         // of the hexagonal lattice inside
  std::uint64_t seed = 1;
};

// The Delaunay triangulation of points on the boundary and of a shaken lattice inside: about so many
// triangles.
[[nodiscard]] Mesh triangulate(Domain domain, double triangles, const DomainPoints& options);

// About so many quads. All boundary vertices are fixed.
[[nodiscard]] Mesh split_quads(Domain domain, double quads, const DomainPoints& options);

}  // namespace quarry::bench
