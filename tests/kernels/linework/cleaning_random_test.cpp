// Ten thousand dirty line sets (RC_PARAMS="max_success=10000", as ./run fuzz has it; fewer by default):
// cleaning ends without failure, the result is fully noded, and every line is there or named as dropped.
// rapidcheck prints the numbers of a set that fails, and its own seed.
#include <cstdlib>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "engine/base/error.hpp"
#include "engine/base/stopwatch.hpp"
#include "tests/kernels/linework/dirty_lines.hpp"

namespace quarry {

void showValue(const DirtySet& set, std::ostream& out) {
  out << "DirtySet{.seed = " << set.seed << "U, .lines = " << set.lines << ", .snap = " << set.snap
      << ", .scale = " << set.scale << ", .offset = " << set.offset << ", .min_edge = " << set.min_edge
      << "}";
}

namespace {

rc::Gen<DirtySet> any_set() {
  using rc::gen::inRange;
  // Few lines are as likely as many.
  const auto lines = rc::gen::map(
      inRange(0, 100), [](int x) { return static_cast<int>(5 * std::pow(100.0, x / 99.0) + 0.5); });
  return rc::gen::build<DirtySet>(
      rc::gen::set(&DirtySet::seed, inRange<std::uint64_t>(0, 1'000'000'000)),
      rc::gen::set(&DirtySet::lines, lines), rc::gen::set(&DirtySet::snap, inRange(2, 10)),
      rc::gen::set(&DirtySet::scale, inRange(-3, 5)), rc::gen::set(&DirtySet::offset, inRange(0, 8)),
      rc::gen::set(&DirtySet::min_edge, rc::gen::element(1.0, 2.0, 5.0)));
}

// Nothing if all is well.
std::string what_is_wrong(const DirtySet& set) {
  const LineSet raw = DirtyLines(set).draw();
  const double snap = std::pow(10, set.scale - set.snap);
  const CleanOptions options{.snap = snap, .min_edge = set.min_edge * snap, .tolerance = snap};
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
  ::setenv("RC_PARAMS", "seed=1 max_success=1500", 0);
  double longest = 0;
  EXPECT_TRUE(rc::check([&] {
    const DirtySet set = *any_set();
    const Stopwatch watch;
    const std::string wrong = what_is_wrong(set);
    longest = std::max(longest, watch.seconds());
    if (!wrong.empty()) RC_FAIL(wrong);
  }));
  RecordProperty("longest", std::to_string(longest));
  std::printf("the longest took %.2f s\n", longest);
}

TEST(DirtyLineSets, AreLaidAnewInNoTimeWhereLinesAreManySnappingDistancesLong) {
  EXPECT_EQ(what_is_wrong({.seed = 528737187U, .lines = 477, .snap = 9, .scale = -1, .offset = 5}), "");
}

}  // namespace
}  // namespace quarry
