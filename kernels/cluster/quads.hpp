// From a triangle mesh with constraints to a smoothed quad mesh: pair, recut and smooth the coarse mixed
// mesh, halve every edge, smooth and optimise. The steps have headers of their own; this is their order and
// their defaults.
//   L. Velho, J. Gomes: Variable resolution 4-k meshes. CGF 19, 2000 (clusters).
//   C. Araujo, W. Celes: Quadrilateral mesh generation with deferred constraint insertion. IMR 23, 2014,
//   section 3.3.
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/cluster/fronts.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/rearrange.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/square_corners.hpp"

namespace quarry {

struct MixedOptions {
  FrontOptions fronts{.steps = 0};
  PairingOptions pairing;
  RearrangeOptions rearrange;
  // How often the mixed mesh is recut and then smoothed; 0: pairing alone, as published.
  int rounds = 2;
  // Smoothing here costs a quarter of what it costs after halving, and reaches twice as far.
  LaplacianOptions smoothing{.sweeps = 2, .tolerance = 0.05};
  SquareCornersOptions square_corners{.sweeps = 4, .floor = 0.4, .tolerance = 0.02};
};

struct QuadOptions {
  MixedOptions mixed;
  LaplacianOptions smoothing{.sweeps = 0, .tolerance = 0.02};
  SquareCornersOptions square_corners;
  OptimiseOptions optimise;
};

// The published procedure: alignment fronts, clusters by longest edge, ten sweeps of smoothing.
[[nodiscard]] QuadOptions paper_quad_options();

struct MixedReport {
  FrontReport fronts;
  PairingReport pairing;
  std::vector<PassReport> rearrange;                   // one a round
  std::vector<SweepReport> smoothing, square_corners;  // one a round
};

struct QuadReport {
  MixedReport mixed;
  SubdivideReport subdivide;
  SweepReport smoothing, square_corners, optimise;
};

// Quads where triangles pair well, single triangles elsewhere, with edges as long as the triangles'. May hold
// tombstones. The triangle mesh (planar, positively oriented, with ConstraintTags) is consumed.
[[nodiscard]] Mesh make_mixed(Mesh&& triangles, const NodedLines& lines, const MixedOptions& options,
                              MixedReport& report, const Progress& progress);

// Quads alone, with edges half as long as the triangles'. No tombstones of faces. Errors as in subdivide().
[[nodiscard]] Mesh make_quads(Mesh&& triangles, const NodedLines& lines, const QuadOptions& options,
                              QuadReport& report, const Progress& progress);

}  // namespace quarry
