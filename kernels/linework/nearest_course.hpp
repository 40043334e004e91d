// A stretch of a path laid anew: from node to node that the raw line comes by, forgetting what it had been
// bent through.
#pragma once

#include <vector>

#include "kernels/linework/node_places.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Steps of a path that is to be laid anew between the steps numbered first and last, which stay.
struct Window {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The windows that cover the marked edges of a path, grown at both ends until they end at steps that are not
// farther than `near` from their raw points, or at an end of the path. Ascending, apart.
[[nodiscard]] std::vector<Window> windows_around(const PathNetwork& network, const Path& path,
                                                 const std::vector<std::uint8_t>& marked, double near);

// Sees to it that the course of a window comes by places of the raw line that it has to keep to: around those
// where the path had left it by more than nodes are apart, and the line's own vertices. A place without a
// node gets one.
void pin_course(NodePlaces& places, const PathNetwork& network, const Path& path, const Window& window);

// The nodes that the stretch of the raw line between two parameters comes by, nearer than nodes are apart, in
// its order; one that it comes by twice, away from it between, twice. Neither parameter gets a step itself.
[[nodiscard]] std::vector<PathStep> nearest_course(const NodePlaces& places, std::span<const Vec2> raw,
                                                   double from, double to);

}  // namespace quarry::linework
