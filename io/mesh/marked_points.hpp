// The vertices of a mesh at points of the input, as formats with groups of nodes want them.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

struct MarkedPoint {
  std::int32_t point;    // number in the input
  std::uint32_t vertex;  // as numbered
};

// By the number of the point, then of the vertex; none where the mesh has no tag kPointTag.
[[nodiscard]] std::vector<MarkedPoint> marked_points(const Mesh& mesh, const LiveNumbering& numbering);

}  // namespace quarry
