// From triangles on a surface to a quad mesh of it: pairs and halved edges, or a matching that halves none,
// and the clean-up and one-defect patches of the plane (kernels/cleanup), which know the surface as a
// SpaceModel. Features and rims stay chains of edges.
#pragma once

#include <optional>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/quads/reach_far_points.hpp"

namespace quarry {

struct SurfaceQuadOptions {
  PairingOptions pairing;
  // In the place of pairs and halved edges; see match_triangles.
  std::optional<MatchingOptions> matching;
  CleanUpLevel cleanup = CleanUpLevel::kFull;
  LocalCleanupOptions local;
  PatchOptions patches;
  // How many times as long as they are on the whole an edge of a patch may be. At twice, twice as many
  // irregular vertices are left; at four times fewer, but quads stretch and leave the surface.
  double longest_edge = 2.5;
  // Where sizes differ from place to place: a quad is to have the area that those around it have, so many
  // rounds of stars away; else (kAllAlike) all are to have the same.
  int area_averages = LocalShapeOptions::kAllAlike;
  // How many faces there are to be; 0: as many as halving makes. Patches keep within a few per cent.
  std::size_t wanted_faces = 0;
  // Sweeps over the whole mesh: after halving, between the steps of clean-up, and at the end.
  int first_sweeps = 5, sweeps_between = 2, last_sweeps = 25;
  ReachOptions reach;
  // More weight for the size than in patches: over a whole mesh quads would stretch.
  ShapeTarget target{.size_weight = 0.3};
  // Of these sweeps, as a share of the edges. With a tenth of it nine vertices in ten move in each of them,
  // each with a search for its place on the surface, and the mean scaled Jacobian is 0.0001 higher.
  double smallest_move = 0.01;
};

struct SurfaceQuadReport {
  PairingReport pairing;
  SubdivideReport subdivide;
  MatchingReport matching;      // in their place
  CleanUpReport clean_up;       // all smoothing is in its smoothing_seconds
  std::size_t reached = 0;      // vertices that were brought to far points of the surface
  std::size_t turned_over = 0;  // faces that are so in the end, by the normals at their free vertices
};

// triangles: as remesh_surface leaves them; consumed. The quads have edges half as long, with matching as
// long as theirs. The result has ConstraintTags and the normals of the surface, and no tombstones. The same
// on any number of threads.
[[nodiscard]] Mesh make_surface_quads(Mesh&& triangles, const SurfaceModel& model,
                                      const CurveNetwork& network, const SurfaceQuadOptions& options,
                                      SurfaceQuadReport& report, const Progress& progress);

// The same from a mesh of quads, or of quads and triangles, that lies on its surface: clean-up, smoothing and
// reach as above, sizes from place to place as they are. mesh: as bind_features leaves it, consumed. Of the
// options and the report what concerns the making of quads is not used.
[[nodiscard]] Mesh improve_surface_quads(Mesh&& mesh, const SurfaceModel& model, const CurveNetwork& network,
                                         const SurfaceQuadOptions& options, SurfaceQuadReport& report,
                                         const Progress& progress);

}  // namespace quarry
