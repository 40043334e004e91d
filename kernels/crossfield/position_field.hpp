// A field of lattice points over a triangle mesh that is aligned with crosses: each vertex has the point of a
// square lattice in its tangent plane that is nearest to it, and the lattices of neighbours agree as far as
// they can. By
//   W. Jakob, M. Tarini, D. Panozzo, O. Sorkine-Hornung: Instant field-aligned meshes. ACM TOG 34(6), 2015
// (positions, extrinsic form), whose averaging this is, from coarse to fine.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "kernels/crossfield/field_level.hpp"

namespace quarry {

struct PositionFieldOptions {
  int sweeps = 6;  // a level
};

// By vertex of the finest of the levels (field_levels): crosses, a direction as cross_field returns it;
// spacing of the lattice, in input units, which should change slowly; places, the lattice points of those
// that are given. Result: the lattice point of each vertex, in its tangent plane. The same on any number of
// threads.
[[nodiscard]] std::vector<Vec3> position_field(std::span<const FieldLevel> levels,
                                               std::span<const Vec3> crosses, std::span<const double> spacing,
                                               std::span<const Vec3> places,
                                               const PositionFieldOptions& options);

}  // namespace quarry
