// From triangles on a surface to a quad mesh of it: pairs, halved edges, and the clean-up and one-defect
// patches of the plane (kernels/cleanup), which know the surface as a SpaceModel. Features and rims stay
// chains of edges.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

struct SurfaceQuadOptions {
  PairingOptions pairing;
  CleanUpLevel cleanup = CleanUpLevel::kFull;
  LocalCleanupOptions local;
  PatchOptions patches;
  // The wanted edge, in input units, and how many times as long an edge of a patch may be. At twice, twice as
  // many irregular vertices are left; at four times fewer, but quads stretch and leave the surface. edge 0:
  // any.
  double edge = 0;
  double longest_edge = 2.5;
  // How many faces there are to be; 0: as many as halving makes. Patches keep within a few per cent.
  std::size_t wanted_faces = 0;
  // Sweeps over the whole mesh: after halving, between the steps of clean-up, and at the end.
  int first_sweeps = 5, sweeps_between = 2, last_sweeps = 25;
  // More weight for the size than in patches: over a whole mesh quads would stretch.
  ShapeTarget target{.size_weight = 0.3};
};

struct SurfaceQuadReport {
  PairingReport pairing;
  SubdivideReport subdivide;
  CleanUpReport clean_up;  // all smoothing is in its smoothing_seconds
};

// triangles: as remesh_surface leaves them, about two wanted edges long; consumed. The quads have edges half
// as long. The result has ConstraintTags and the normals of the surface, and no tombstones. The same on any
// number of threads.
[[nodiscard]] Mesh make_surface_quads(Mesh&& triangles, const SurfaceModel& model,
                                      const CurveNetwork& network, const SurfaceQuadOptions& options,
                                      SurfaceQuadReport& report, const Progress& progress);

}  // namespace quarry
