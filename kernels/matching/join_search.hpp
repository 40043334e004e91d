// Makes a join cheaper: toggles stars of vertices and pairs of adjacent stars while that lowers the cost, the
// best moves of each neighbourhood first; and simulated annealing where the last Steiner points are worth its
// time.
#pragma once

#include <cstdint>

#include "engine/base/progress.hpp"
#include "kernels/matching/merge_cost.hpp"

namespace quarry {

struct JoinSearchOptions {
  bool pairs = true;
  // Rounds of the descent at most; it ends by itself when nothing improves. Each commits an independent set
  // of moves.
  int rounds = 200;
  // Sweeps of annealing between the descents by stars and by pairs, near Steiner points alone, from the first
  // to the last temperature (as shares of the cost of a Steiner point; the higher that cost, the fewer are
  // left and the worse is the mean quad). What a vertex draws in a sweep is a function of its number, the
  // sweep and the seed.
  int annealing_sweeps = 0;
  double hottest = 0.5;
  double coldest = 0.0125;
  std::uint64_t seed = 0;
};

struct JoinSearchReport {
  std::uint64_t rounds = 0;
  std::uint64_t evaluated = 0;  // moves looked at
  std::uint64_t stars = 0;      // moves made around one vertex
  std::uint64_t pairs = 0;      // and around two
  std::uint64_t annealing_moves = 0;
};

// Changes the join in place; every face keeps an odd number of arcs. In parallel: moves of a round touch no
// vertex in common, and who moves is decided by change in cost, then by a hash, so that the result is the
// same on any number of threads.
void improve_join(const Mesh& mesh, ConstraintTags tags, const MergeCosts& costs,
                  const JoinSearchOptions& options, DualArcs& join, JoinSearchReport& report,
                  const Progress& progress);

}  // namespace quarry
