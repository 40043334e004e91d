// Dirty line sets for rapidcheck, which prints the numbers of one that fails.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <ostream>
#include <string>

#include <ctime>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/kernels/linework/dirty_lines.hpp"

namespace quarry {

// As rapidcheck prints it.
inline std::ostream& operator<<(std::ostream& out, const DirtySet& set) {
  return out << "DirtySet{.seed = " << set.seed << "U, .lines = " << set.lines << ", .snap = " << set.snap
             << ", .scale = " << set.scale << ", .offset = " << set.offset << ", .min_edge = " << set.min_edge
             << "}";
}

// Of the processor, all threads together: what else the machine does makes nothing slow.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

// Names the sets that take long: ten seconds of the processor are too much for any.
class SlowSets {
 public:
  void note(const DirtySet& set, double seconds) {
    longest_ = std::max(longest_, seconds);
    if (seconds < kSlow) return;
    std::cout << seconds << " s: " << set << std::endl;
  }
  ~SlowSets() { std::cout << "the longest took " << longest_ << " s\n"; }

 private:
  static constexpr double kSlow = 5;
  double longest_ = 0;
};

inline rc::Gen<DirtySet> any_set() {
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

// Draws sets, as RC_PARAMS says or else the parameters given, and names the first of which something is
// wrong. what_is_wrong(set): a text, empty if all is well.
template <class WhatIsWrong>
void expect_all_right(const char* parameters, WhatIsWrong&& what_is_wrong) {
  ::setenv("RC_PARAMS", parameters, 0);
  SlowSets slow;
  EXPECT_TRUE(rc::check([&] {
    const DirtySet set = *any_set();
    const double begin = processor_seconds();
    const std::string wrong = what_is_wrong(set);
    slow.note(set, processor_seconds() - begin);
    if (!wrong.empty()) RC_FAIL(wrong);
  }));
}

}  // namespace quarry
