// The edges of a mesh once each: a piece of several lines is an edge for each of them.
#pragma once

#include <cstdint>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

// Places in numbering.edges(), ascending: of edges over the same two vertices the one with the smallest
// number, -1 first.
[[nodiscard]] std::vector<std::uint32_t> single_edges(const Mesh& mesh, const LiveNumbering& numbering);

// Those of them that are fractures to codes of finite elements: interior constraints, on the left side alone
// where the mesh is split.
[[nodiscard]] std::vector<std::uint32_t> fracture_edges(const Mesh& mesh, const LiveNumbering& numbering);

}  // namespace quarry
