// How good it would be to merge two triangles across their shared edge.
#pragma once

#include <array>

#include "engine/mesh/mesh.hpp"

namespace quarry {

enum class PairMeasure {
  kLongestEdge,  // the length of the shared edge: Velho & Gomes 2000, as used by Araujo & Celes 2014,
                 // section 3.3
  kQuadQuality,  // the smallest corner sine of the merged quad
};

// The corners of the quad that merging across s makes, counter-clockwise, from the end of s on.
[[nodiscard]] std::array<VertexId, 4> merged_corners(const Mesh& mesh, SideId s);

// The same squares as corner sines keep their order without square roots: sin |sin| of the worst corner of a
// quad, in [-1, 1], positive if it is strictly convex up to rounding.
[[nodiscard]] double worst_corner_signed_square(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

// True if the edge of s is no shorter than the other edges of its face. Ties count as longest.
[[nodiscard]] bool longest_of_its_face(const Mesh& mesh, SideId s);

}  // namespace quarry
