// Soups so dense that the distance kept between nodes is near the distance between the lines: whatever has
// to be bent, joined or laid anew there, every line stays within its budget.
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/kernels/linework/line_samples.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {
namespace {

constexpr CleanOptions kDense{.snap = 0.1, .min_edge = 0.2, .tolerance = 0.1};

// Lines of 2 to `most` random points in a square of side 100.
LineSet random_lines(std::uint64_t seed, int count, int most) {
  Dice dice(seed);
  std::vector<Points> lines;
  for (int i = 0; i < count; ++i) {
    Points line;
    const int size = 2 + static_cast<int>(dice(0, most - 1));
    for (int k = 0; k < size; ++k) line.push_back({dice(0, 100), dice(0, 100)});
    lines.push_back(line);
  }
  return lines_of(lines);
}

void expect_clean(const LineSet& raw, const Outline& outline, const CleanOptions& options) {
  CleanedLines result;
  ASSERT_NO_THROW(result = clean_lines(raw, outline, options));
  EXPECT_LE(result.counts.largest_move, budget(options) * (1 + 1e-9));
  expect_faithful(raw, result);
}

TEST(DenseSoups, KeepFifteenHundredLinesWithinTheBudget) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = random_lines(seed, 1500, 2);
    expect_clean(raw, box_outline(raw, kDense.snap), kDense);
  }
}

TEST(DenseSoups, KeepThreeThousandLinesWithinTheBudget) {
  const LineSet raw = random_lines(1, 3000, 2);
  expect_clean(raw, box_outline(raw, kDense.snap), kDense);
}

TEST(DenseSoups, KeepThreeHundredCrookedLinesWithinTheBudget) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = random_lines(seed, 300, 4);
    expect_clean(raw, box_outline(raw, kDense.snap), kDense);
  }
}

// No slack at all: shortest pieces of the snapping distance, no tolerance.
TEST(DenseSoups, KeepTheSmallestBudget) {
  constexpr CleanOptions kTight{.snap = 0.2, .min_edge = 0.2, .tolerance = 0};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = random_lines(seed, 300, 3);
    expect_clean(raw, hull_outline(raw, kTight.snap), kTight);
  }
}

TEST(DenseSoups, StayWithinTheBudgetFarFromTheOrigin) {
  LineSet raw = random_lines(7, 600, 3);
  for (InputLine& line : raw.lines)
    for (Vec2& p : line.points) p = p + Vec2{466'000, 6'700'000};
  expect_clean(raw, box_outline(raw, kDense.snap), kDense);
}

}  // namespace
}  // namespace quarry
