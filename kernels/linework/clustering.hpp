// The first nodes of a network: points of the raw lines that are apart.
#pragma once

#include <vector>

#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Builds the network: raw points cluster to nodes at least sqrt(2) * snap apart, with the coordinates of one
// of them; points of the outline come first, then ends of lines, then the rest, each in reading order. Nodes
// and paths are numbered by place.
[[nodiscard]] PathNetwork cluster_points(std::vector<RawLine> raw, double snap);

}  // namespace quarry::linework
