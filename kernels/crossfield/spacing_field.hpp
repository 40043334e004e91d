// The spacing that lets the rows of a lattice follow a field of crosses. Where crosses turn, rows of equal
// width run into one another or apart, and the lattice has to begin and to end rows in the middle: each such
// place is a dislocation, a pair of vertices of three and of five quads. None is needed where the spacing s
// changes across the turn,
//   grad log s = -J grad theta        (theta: angle of the crosses, J: a quarter turn to the left),
// the curl correction of
//   N. Ray, W. C. Li, B. Levy, A. Sheffer, P. Alliez: Periodic global parameterization. ACM TOG 25(4), 2006
// for squares that stay squares.
#pragma once

#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/crossfield/field_level.hpp"

namespace quarry {

struct SpacingFieldOptions {
  // How far the spacing follows the turns, in edges of the mesh: what comes of turns farther away fades.
  double reach = 15;
  // The logarithm of the spacing is nowhere farther from that on the whole than this.
  double most = 0.15;
  int steps = 200;         // of conjugate gradients, at most
  double accuracy = 1e-3;  // of the residual, beside the first one
};

// What the turns of crosses (as cross_field returns them) ask of the spacing at each vertex of a mesh of
// nearly equilateral triangles: the right-hand side of the least squares problem. level: the finest one, that
// of the mesh.
[[nodiscard]] std::vector<double> spacing_sources(const Mesh& mesh, const FieldLevel& level,
                                                  std::span<const Vec3> directions);

// The logarithm of the spacing at each vertex, beside that on the whole. sources: of the same mesh; where it
// was cut open for them, their sums. The same on any number of threads.
[[nodiscard]] std::vector<double> spacing_field(const Mesh& mesh, std::span<const double> sources,
                                                const SpacingFieldOptions& options);

}  // namespace quarry
