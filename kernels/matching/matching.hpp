// Quads from any triangle mesh by matching on the tree of its dual graph, without halving a single edge that
// need not be: for outlines that must stay as they are, and for surfaces.
//   S. Ramaswami, P. Ramos, G. Toussaint: Converting triangulations to quadrangulations. Comput. Geom. 9,
//   1998. C. Verma, T. Tautges: Jaal: engineering a high quality all-quadrilateral mesh generator. IMR 20,
//   2011.
// Beyond these: the tree is the maximum spanning forest of the dual, constraints are kept by making each
// region even first, and a local search over stars takes away nearly all Steiner points and bad quads.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/matching/ears.hpp"
#include "kernels/matching/join_search.hpp"
#include "kernels/matching/merge_cost.hpp"
#include "kernels/matching/openings.hpp"
#include "kernels/matching/region_parity.hpp"
#include "kernels/matching/rings.hpp"
#include "kernels/matching/short_ways.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/optimise_shape.hpp"

namespace quarry {

// What orders the arcs of the spanning forest.
enum class MatchingStart {
  kShapes,  // the shape of the merged quads alone: no worse quad than any join needs, but many Steiner points
  kShortWays,  // good pairs first, then short alternating ways between the triangles left single
};

struct MatchingOptions {
  // No boundary edge may be halved; an odd boundary is then an error.
  bool keep_boundary = false;
  EarOptions ears;
  MatchingStart start = MatchingStart::kShortWays;
  ShortWayOptions short_ways;
  JoinCostOptions cost;
  bool search = true;
  JoinSearchOptions searching;
  // Triangles are flipped to better ones and smoothed before they are matched.
  bool better_triangles = true;
  LaplacianOptions smoothing{.sweeps = 4, .tolerance = 0.02};
  // Quads are smoothed, and their straight corners opened, this often.
  int opening_rounds = 2;
  OpeningOptions openings;
  // What is inverted then gets rings, which cut constrained edges, at most this often.
  int ring_rounds = 6;
  ShapeOptions shape{.sweeps = 6};
  OptimiseOptions optimise;
  // Throw where a quad stays inverted; else only count it.
  bool require_valid = true;
};

struct MatchingReport {
  ParityReport parity;
  EarReport ears;
  std::uint64_t forest_rounds = 0;
  JoinSearchReport search;
  std::uint64_t quads = 0;
  std::uint64_t steiner_points = 0;
  PassReport flips;
  std::vector<PassReport> rings;
  std::vector<PassReport> openings;    // one a round
  std::vector<SweepReport> smoothing;  // of triangles, and then one a round
  SweepReport optimise;
  std::uint64_t invalid = 0;  // quads left that are not strictly convex
};

// The join of a triangle mesh, planar or not, open or closed, whose regions are all even: every triangle has
// one or three arcs.
[[nodiscard]] DualArcs find_join(const Mesh& mesh, ConstraintTags tags, const MatchingOptions& options,
                                 MatchingReport& report, const Progress& progress);

// Halves constrained and boundary edges of a planar mesh until every region is even, and opens forced ears:
// what find_join needs. Vertices keep their numbers.
void prepare_for_join(Mesh& mesh, ConstraintTags tags, const NodedLines& lines,
                      const MatchingOptions& options, MatchingReport& report, const Progress& progress);

// Quads alone from a planar triangle mesh (positively oriented, with ConstraintTags), with edges as long as
// the triangles', smoothed. No tombstones of faces. Throws Error(kGeometry) for an odd frozen boundary, and
// with the place where a quad stays inverted.
[[nodiscard]] Mesh make_quads_by_matching(Mesh&& triangles, const NodedLines& lines,
                                          const MatchingOptions& options, MatchingReport& report,
                                          const Progress& progress);

// Throws Error(kGeometry) with the number of quads that are not strictly convex, the place of the first and
// the remedy, if there are any. For whoever goes on mending after require_valid = false.
void require_convex_quads(const Mesh& mesh);

}  // namespace quarry
