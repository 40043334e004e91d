// Flips the edges of a surface mesh towards triangles that are nearer to equilateral, and vertices of six.
#pragma once

#include "surface/remesh/state.hpp"

namespace quarry {

enum class FlipAim : std::uint8_t {
  kMeasure,  // the worse of the two triangles becomes better
  kValence,  // the four vertices come nearer to six triangles, on rims to three, at no great loss
};

// Only where the two triangles lie nearly flat beside one another, and both new ones face as the surface
// does. Constrained edges stay. What it won are flips.
PassReport flip_edges(RemeshState& state, FlipAim aim, const Progress& progress);

}  // namespace quarry
