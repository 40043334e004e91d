// What counts as a feature of a surface.
#pragma once

#include <optional>

namespace quarry {

struct FeatureOptions {
  // An edge across which the surface turns by at least so many degrees is sharp; 180 and more: no edge is, by
  // itself. Unset: what the surface itself tells (surface/feature/sharpness.hpp).
  std::optional<double> sharp_degrees = {};
  // A sharp edge must also turn so many times as much as the surface beside it does: on a noisy scan all
  // edges turn. Beside it are the other two edges of each triangle, of which the flatter one counts. An edge
  // as long as the shortest chain need not.
  double contrast = 2.5;
  // A chain that has an edge as sharp as that goes on along edges that turn by this share of it.
  double weakest_share = 0.6;
  // Chains of sharp edges shorter than so many times `size` are noise, and so are ends that hang out of a
  // network by less than half of that.
  double shortest_chain = 4;
  // A chain that turns by at least so many degrees, from one `size` before to one behind, has a corner there.
  double corner_degrees = 50;
  // Set: a chain has corners, in place of those, wherever it lies farther than this (in input units) from the
  // straight stretches between them (engine/geometry/straight_runs.hpp): what is bent keeps its points.
  std::optional<double> straightness = {};
  // The wanted edge of the mesh, in input units: the scale at which chains are judged. 0: single edges are.
  double size = 0;
  // Borders between groups of triangles are features.
  bool group_borders = true;
};

}  // namespace quarry
