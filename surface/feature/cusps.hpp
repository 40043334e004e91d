// Points of a surface at which it comes to a tip, as the apex of a cone does, and that lie on no edge that
// would hold them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

// Numbers of points, ascending, of those that are not bound to a feature (bound: by point, nonzero). A point
// is a cusp if its triangles have angles of at most 270 degrees there all together (360 where the surface is
// smooth), and spheres around it, up to one of radius `size` (in input units), cut the surface around it in
// courses that turn by no more as it sees them: a tooth of a noisy surface does so only up to its own size.
// No cusp lies nearer than `size` to a feature or to one that is more pointed. None where size is 0.
[[nodiscard]] std::vector<std::uint32_t> find_cusps(const TriangleSurface& surface,
                                                    std::span<const std::uint8_t> bound, double size);

}  // namespace quarry
