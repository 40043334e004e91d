// The smoothest field of crosses on a triangle mesh: at each vertex four directions a quarter turn apart, by
// the complex number of four times their angle; rims and features are data, and nothing else is:
//   F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Globally optimal direction fields. ACM TOG 32(4), 2013.
// The linear problem is solved directly on a coarse level of a hierarchy; on the finer ones crosses of length
// 1 are swept over.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "kernels/crossfield/field_level.hpp"

namespace quarry {

struct CrossFieldOptions {
  // The level with at most so many free vertices is solved directly; beyond the finest: all of it is.
  std::size_t coarsest = 400;
  int sweeps = 6;               // Gauss-Seidel sweeps a level
  int inverse_iterations = 20;  // where nothing is given: towards the smallest eigenvector
};

// The finest of the levels (field_levels) has the given directions, unit and tangent, where `given` is 1;
// others are not read. Result: one of the four directions at each vertex of the finest level, unit and
// tangent. The same on any number of threads.
[[nodiscard]] std::vector<Vec3> cross_field(std::span<const FieldLevel> levels,
                                            std::span<const Vec3> directions,
                                            const CrossFieldOptions& options);

// The complex number of a direction at a vertex of a level, and the direction of such a number.
[[nodiscard]] Vec2 cross_number(const FieldLevel& level, std::size_t i, Vec3 direction);
[[nodiscard]] Vec3 cross_direction(const FieldLevel& level, std::size_t i, Vec2 number);

}  // namespace quarry
