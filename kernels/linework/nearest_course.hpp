// A stretch of a path laid anew: from node to nearest node along the raw line, forgetting what it had been
// bent through.
#pragma once

#include <vector>

#include "kernels/linework/path_network.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {

// Steps of a path that is to be laid anew between the steps numbered first and last, which stay.
struct Window {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The windows that cover the marked edges of a path, grown at both ends until they end at steps that are not
// farther than `near` from their raw points, or at an end of the path. Ascending, apart.
inline std::vector<Window> windows_around(const PathNetwork& network, const Path& path,
                                          const std::vector<std::uint8_t>& marked, double near) {
  const auto far = [&](std::size_t i) {
    const PathStep& step = path.steps[i];
    return distance(raw_point(network.raw[path.raw].points, step.at), network.nodes[step.node]) > near;
  };
  std::vector<Window> windows;
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
    if (marked[i] == 0) continue;
    Window window{i, i + 1};
    while (window.first > 0 && far(window.first)) --window.first;
    while (window.last + 1 < path.steps.size() && far(window.last)) ++window.last;
    if (!windows.empty() && window.first < windows.back().last) {
      windows.back().last = std::max(windows.back().last, window.last);
    } else {
      windows.push_back(window);
    }
  }
  return windows;
}

// The nodes that the stretch of the raw line between two parameters comes by, where node_at(p) tells the node
// for a point; the line is sampled at this spacing. Neither parameter gets a step itself.
template <class NodeAt>
std::vector<PathStep> nearest_course(const PathNetwork& network, std::span<const Vec2> raw, double from,
                                     double to, double spacing, NodeAt&& node_at) {
  std::vector<PathStep> steps;
  double entered = from;  // where the line came to the node of the last step
  for (double at = advance(raw, from, to, spacing); at < to; at = advance(raw, at, to, spacing)) {
    const NodeId node = node_at(raw_point(raw, at));
    if (steps.empty() || steps.back().node != node) {
      entered = at;
      steps.push_back({node, at});
    } else {
      steps.back().at = nearest_parameter(raw, entered, at, network.nodes[node]);
    }
  }
  return steps;
}

}  // namespace quarry::linework
