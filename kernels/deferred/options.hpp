// Options and reports of deferred constraint insertion.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/operation/pass.hpp"

namespace quarry {

struct DeferredOptions {
  // An attraction is accepted if the worst triangle of the star keeps at least this Lo measure (eq. 5) ...
  double min_quality = 0.1;
  // ... and if the worst measure of the star falls by at most this share of itself (eq. 6).
  double max_distortion = 0.5;
  // Both limits give way by try: the distortion grows by 1 / relaxation each try; the quality shrinks by
  // quality_relaxation each try past patient_tries.
  double relaxation = 0.9;
  double quality_relaxation = 0.7;
  std::uint32_t patient_tries = 6;
  // After this many tries at one step, or on an edge shorter than the floor, the step that is always valid is
  // taken.
  std::uint32_t max_tries = 12;
  double length_floor = 0.005;  // share of the spacing below
  double spacing = 1;           // wanted edge of the triangles, in input units
  // An edge may be split if it is at least this share of the longest of its triangle.
  double close_to_longest = 0.8;
  // A crossed edge is flipped in place of split if the two triangles then reach this measure, or improve.
  double flip_quality = 0.35;
  // Smoothing of the star after each attraction.
  std::uint32_t sweeps = 3;
  bool inverse_length_weights = false;  // the scale-dependent umbrella of the paper, w = 1 / length
  bool guard_star_minimum =
      true;  // a move never lowers the worst triangle of its star; else only min_quality
  std::size_t max_faces = PassOptions().max_faces;  // beyond it the call ends with Error(kBudget)
  bool use_flips = true;
  bool several_targets = true;  // else the crossing alone is tried
  bool wedge_relative = true;   // quality limits follow the angle between pieces that share a node
};

// The published procedure (Araujo & Celes 2014), with the reading of its relaxation that ends
// (a maximum is relaxed by growing). Termination and validity are those of the default.
[[nodiscard]] DeferredOptions paper_options(double spacing);

struct DeferredReport {
  PassReport nodes, pieces;
  std::uint64_t attractions = 0;  // vertices moved to a node or onto a piece
  std::uint64_t taken = 0;        // vertices found on a piece or a node
  std::uint64_t flips = 0;
  std::uint64_t splits = 0;
  std::uint64_t fallbacks = 0;   // steps by the rule that is always valid
  std::uint64_t rebuilt = 0;     // pieces whose rest was put in by retriangulating what it crosses
  std::uint64_t most_tries = 0;  // at one step
};

}  // namespace quarry
