// One direction along each line of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// For each edge whether it runs against the direction of its line, where all edges with the same tag
// "constraint" that follow one another have one: from the end whose edge has the smaller number. Lines part
// where more than two of their edges meet.
[[nodiscard]] std::vector<bool> find_backward_edges(const Mesh& mesh);

}  // namespace quarry
