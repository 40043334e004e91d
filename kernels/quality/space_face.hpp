// Measures of a face of a surface in space: the verdict on it, and Lo's of a triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/geometry/space_point.hpp"

namespace quarry {

// The mean of the cosines of the angles by which a face turns from the normals of the surface at its corners
// is at least that of 72 degrees. A scaled Jacobian alone does not see a face that lies upside down, nor does
// the angle to the mean of these normals see one that leads from one side of a blade to the other, far behind
// its edge: what they have in common points away from the blade.
inline constexpr double kLeastFacing = 0.3;

// What a face that is not convex, or lies upside down, has at most.
inline constexpr double kNotConvex = -0.1;

// The smallest corner sine (of a triangle times 2 / sqrt(3)) as seen along the face's own normal, the cross
// product of its diagonals; at most kNotConvex where it is not positive. Where that normal turns too far from
// the surface: between that and 0 for a face that would be valid otherwise, so that no change makes it not
// convex for the sake of its direction; -1 if it points away, or there is none.
[[nodiscard]] inline double scaled_jacobian_in_space(std::span<const SpacePoint> corners) {
  constexpr double kTriangleFactor = 1.1547005383792515;
  const std::size_t count = corners.size();
  const Vec3 normal = count == 3 ? cross(corners[1] - corners[0], corners[2] - corners[0])
                                 : cross(corners[2] - corners[0], corners[3] - corners[1]);
  Vec3 up;
  double all = 0;
  for (const SpacePoint& corner : corners) {
    up = up + corner.up;
    all += length(corner.up);
  }
  const double size = length(normal);
  const double facing = dot(normal, up);
  const double least = kLeastFacing * size * all;
  if (!(size > 0) || !(facing >= 0)) return -1;
  double smallest = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const SpacePoint out = corners[(k + 1) % count] - corners[k];
    const SpacePoint back = corners[(k + count - 1) % count] - corners[k];
    const double lengths = std::sqrt(dot(out, out) * dot(back, back));
    smallest = std::min(smallest, lengths > 0 ? dot(cross(out, back), normal) / (lengths * size) : -1.0);
  }
  if (count == 3) smallest = std::min(1.0, kTriangleFactor * smallest);
  if (!(smallest > 0)) return std::min(smallest, kNotConvex);
  return facing >= least ? smallest : kNotConvex * (1 - 0.9 * smallest);
}

// Lo's measure of a triangle in space: 1 if equilateral, 0 if flat. Has no sign.
[[nodiscard]] inline double lo_measure(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? 3.4641016151377546 * length(cross(ab, bc)) / squares : 0;
}

}  // namespace quarry
