// Pairs triangles into quads, best pair first: Velho & Gomes 2000; Araujo & Celes 2014, section 3.3. The
// serial greedy order is kept exactly by locally dominant rounds: a pair that is the best choice of both its
// triangles is what the greedy order would take sooner or later, whatever happens elsewhere.
#pragma once

#include <cstdint>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/cluster/pair_measure.hpp"

namespace quarry {

struct PairingOptions {
  PairMeasure measure = PairMeasure::kQuadQuality;
  // Smallest corner sine that a merged quad may have.
  double convex_margin = 0.1;
};

// Who is merged with whom: of each triangle its own side that vanishes, or none if it stays single.
struct Pairing {
  IdVector<FaceId, SideId> merged;
};

struct PairingReport {
  std::uint64_t rounds = 0;
  std::uint64_t pairs = 0;
  std::uint64_t singles = 0;
};

// What a pair is worth in one pass of the greedy order; pairs are taken in decreasing order, ties by the
// smaller of the two side numbers. Negative: not allowed. Side and its neighbour have the same worth. Pass 0
// of kLongestEdge takes edges that are longest of one of their triangles at least, pass 1 the rest;
// kQuadQuality has one pass.
[[nodiscard]] float pair_worth(const Mesh& mesh, ConstraintTags tags, SideId s, int pass,
                               const PairingOptions& options);
[[nodiscard]] int pairing_passes(const PairingOptions& options);

// Pairs the triangles of a triangle mesh (tombstones are skipped). In space a quad is judged as it looks
// along its own normal, and its triangles must lie nearly flat beside one another. Constrained edges are
// never merged across. Scratch memory: 20 bytes a triangle beside the result.
[[nodiscard]] Pairing pair_triangles(const Mesh& mesh, ConstraintTags tags, const PairingOptions& options,
                                     PairingReport& report, const Progress& progress);

}  // namespace quarry
