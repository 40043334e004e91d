// Ten thousand dirty line sets (RC_PARAMS="max_success=10000", as ./run fuzz has it; fewer by default):
// cleaning ends without failure, the result is fully noded, and every line is there or named as dropped.
// rapidcheck prints the numbers of a set that fails, and its own seed.
#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/kernels/linework/dirty_sets.hpp"

namespace quarry {

namespace {

// Nothing if all is well.
std::string what_is_wrong(const DirtySet& set) {
  const LineSet raw = DirtyLines(set).draw();
  const double snap = std::pow(10, set.scale - set.snap);
  const CleanOptions options{.snap = snap,
                             .min_edge = set.min_edge * snap,
                             .tolerance = snap,
                             .closed_wedge = set.seed % 2 == 0 ? 0.0 : 10.0};
  CleanedLines result;
  try {
    result = clean_lines(raw, box_outline(raw, snap), options);
    require_noded(result.lines, result.options.snap);
  } catch (const Error& error) {
    return error.message();
  }
  const auto pieces = pieces_by_line(result.lines, raw.lines.size());
  for (const LineId id : IdRange<LineId>(raw.lines.size())) {
    const LedgerEntry& entry = result.ledger[id];
    const bool dropped = entry.fate == LineFate::kDropped;
    if (dropped != pieces[id].empty()) return "line " + std::to_string(id.value()) + " is lost";
    if (dropped && entry.why.empty())
      return "line " + std::to_string(id.value()) + " is dropped without reason";
    if (entry.moved > budget(result.options) * (1 + 1e-9) + result.options.snap / 256)
      return "line " + std::to_string(id.value()) + " moved too far";
  }
  return {};
}

TEST(DirtyLineSets, AreCleanedWithEveryLineThereOrNamed) {
  expect_all_right("seed=1 max_success=1500", what_is_wrong);
}

TEST(DirtyLineSets, AreLaidAnewInNoTimeWhereLinesAreManySnappingDistancesLong) {
  EXPECT_EQ(what_is_wrong({.seed = 528737187U, .lines = 477, .snap = 9, .scale = -1, .offset = 5}), "");
}

// Bending led these astray in ways that laying paths anew by nodes at a fixed spacing did not end: each such
// node bent the lines beside it.
TEST(DirtyLineSets, EndWhereLinesRunBesideOneAnotherForManySnappingDistances) {
  for (const std::uint64_t seed : {775655979U, 763256763U, 775561295U})
    EXPECT_EQ(what_is_wrong({.seed = seed, .lines = 314, .snap = 9, .scale = -3, .offset = 3, .min_edge = 5}),
              "");
}

// A node was put back on its raw line, moved onto the outline and became one with a node there, each round.
TEST(DirtyLineSets, EndWhereTheOutlineTakesWhatHoldsALine) {
  EXPECT_EQ(what_is_wrong({.seed = 975728865U, .lines = 207, .snap = 2, .scale = -3, .min_edge = 5}), "");
}

// A path that was laid anew in four hundred stretches got thousands of nodes in each, and a hundred lines
// beside it were bent through all of them: millions of steps.
TEST(DirtyLineSets, AreLaidAnewInManyStretchesWithoutMoreNodesForIt) {
  const DirtySet set{.seed = 941419628U, .lines = 103, .snap = 8, .scale = -2, .offset = 3};
  const LineSet raw = DirtyLines(set).draw();
  const double snap = 1e-10;
  const CleanedLines result =
      clean_lines(raw, box_outline(raw, snap), {.snap = snap, .min_edge = snap, .tolerance = snap});
  EXPECT_LT(result.counts.bends, 100'000U);
}

}  // namespace
}  // namespace quarry
