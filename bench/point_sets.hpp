// Delaunay triangulations of unconstrained squares that matching is measured on, from point sets of several
// kinds.
#pragma once

#include <array>
#include <cstdint>

#include "engine/mesh/mesh.hpp"

namespace quarry::bench {

enum class PointSet : std::uint8_t {
  kRelaxed,     // drawn in the cells of a grid, three times moved to the mean of those around
  kJittered,    // drawn in the cells of a grid
  kShakenRows,  // a hexagonal lattice, each point moved by up to a quarter of the spacing
  kRows,        // the same, by up to a hundredth
};
inline constexpr std::array kPointSets = {PointSet::kRelaxed, PointSet::kJittered, PointSet::kShakenRows,
                                          PointSet::kRows};
[[nodiscard]] const char* name_of(PointSet points);

// About so many triangles, an even number of them: one outer edge is halved if need be.
[[nodiscard]] Mesh even_triangles(double triangles, PointSet points);

}  // namespace quarry::bench
