// Which noded edges lie in the domain, which on its boundary, and the clipping of paths to it.
#pragma once

#include <vector>

#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

enum class EdgePlace : std::uint8_t { kOutside, kInside, kBoundary };

// The place of each edge of the last build_edges(). A point is in the domain if for some polygon it lies
// within an odd number of the polygon's rings; a boundary edge has the domain on exactly one side. The rings
// are taken as the outline's paths now run. Needs a noded network.
[[nodiscard]] std::vector<EdgePlace> edge_places(const PathNetwork& network);

// Takes the steps from the paths of input points outside the domain. Before clip_to_domain, with the same
// places.
void drop_points_outside(PathNetwork& network, const std::vector<EdgePlace>& places);

// Cuts paths to the edges that lie in the domain or on its boundary. Afterwards a path is an outline path
// exactly if all its edges are boundary edges of its ring; rings that are no input line keep those edges
// alone. Returns for each raw line the length of it that went.
[[nodiscard]] std::vector<double> clip_to_domain(PathNetwork& network, const std::vector<EdgePlace>& places);

}  // namespace quarry::linework
