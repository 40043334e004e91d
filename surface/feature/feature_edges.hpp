// The edges of a surface that a mesh of it must keep.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/feature/options.hpp"
#include "surface/imprint/imprint.hpp"
#include "surface/repair/repair.hpp"
#include "surface/repair/surface_edges.hpp"

namespace quarry {

enum class FeatureKind : std::uint8_t {
  kSharp,   // the surface turns
  kBorder,  // between two groups
  kLine,    // of an input line that was imprinted
  kRim,     // one triangle
  kJoin,    // a branch or a seam: sheets end here and meet
};

struct FeatureEdge {
  std::array<std::uint32_t, 2> ends;  // points, ascending
  FeatureKind kind;
  std::int32_t line = -1;  // its number

  friend bool operator==(const FeatureEdge&, const FeatureEdge&) = default;
};

struct FeatureEdges {
  std::vector<FeatureEdge> edges;
  double sharp_degrees = 0;  // as used
};

// All features, ascending by their ends. Of several kinds an edge has the last in the order of FeatureKind.
// Sharp edges are found with hysteresis: a chain begins at an edge that is sharp and goes on along edges that
// are nearly so; what stays short, or hangs loose by a short end, is left out.
// lines: edges that lines go along, ascending. within: edges that divide a face of more than three corners
// into triangles, ascending: none of them is sharp.
[[nodiscard]] FeatureEdges find_feature_edges(const RepairedSurface& repaired, const FeatureOptions& options,
                                              std::span<const LineEdge> lines = {},
                                              std::span<const SheetJoin> within = {});

}  // namespace quarry
