// A start mesh of nearly equilateral triangles: the Delaunay triangulation of well-spaced points, which are
// those of a hexagonal lattice, shaken a little so that no direction is preferred.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct DelaunayOptions {
  double spacing = 1;        // wanted edge of a triangle, in the units of the box
  double angle_degrees = 0;  // the rows are turned by this, counter-clockwise
  // Largest displacement of a point, as a share of the spacing. Up to 0.25 points stay half a spacing apart.
  double jitter = 0.1;
  std::uint64_t seed = 0;
};

// The points: they cover the box and two rows more on each side, of which the outer one is not shaken.
// Not turned, rows run along the lower and the upper side of the box. In rows.
[[nodiscard]] std::vector<Vec2> make_spaced_points(const Box2& box, const DelaunayOptions& options);

// Their triangulation, in Hilbert order. What lies in the box is away from the hull. Vertices bear no tag.
[[nodiscard]] Mesh make_delaunay(const Box2& box, const DelaunayOptions& options);

// About how many triangles make_delaunay would make: for telling before doing.
[[nodiscard]] double count_delaunay_triangles(const Box2& box, const DelaunayOptions& options);

}  // namespace quarry
