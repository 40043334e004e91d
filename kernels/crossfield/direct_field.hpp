// The smoothest crosses of one level by a direct factorisation.
#pragma once

#include <vector>

#include "kernels/crossfield/field_level.hpp"

namespace quarry {

// crosses: those of given vertices, by vertex; gets those of the others, of any length. In a part of the mesh
// that knows of something given they are the minimum of z^H A z, in others nearly the eigenvector of A with
// the smallest eigenvalue, by inverse iteration.
void solve_directly(const FieldLevel& level, int inverse_iterations, std::vector<Vec2>& crosses);

}  // namespace quarry
