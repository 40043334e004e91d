// Random soups: whatever the lines, cleaning ends, keeps its promises (checked exactly by clean_lines) and
// stays within its budget.
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/kernels/linework/line_samples.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {
namespace {

void clean_soups(std::uint64_t first, std::uint64_t last, Vec2 origin, double size) {
  const CleanOptions options{0.05 * size, 0.1 * size, 0.05 * size};
  for (std::uint64_t seed = first; seed < last; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = soup(seed, origin);
    const Outline outline = seed % 2 == 0 ? box_outline(raw, options.snap) : wide_box(raw);
    CleanedLines result;
    ASSERT_NO_THROW(result = clean_lines(raw, outline, options));
    expect_faithful(raw, result);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(CleaningSoups, StayWithinTheBudget) { clean_soups(0, 600, {}, 0.3); }
TEST(CleaningSoups, StayWithinTheBudgetWhereSnapIsLarge) { clean_soups(1000, 1600, {}, 1.0); }
TEST(CleaningSoups, StayWithinTheBudgetWhereSnapIsSmall) { clean_soups(2000, 2300, {}, 0.001); }
TEST(CleaningSoups, StayWithinTheBudgetFarFromTheOrigin) {
  clean_soups(3000, 3400, {466'000, 6'700'000}, 0.2);
}

// Random polygons with random lines across them, at sizes at which small rings and gaps close up.
TEST(CleaningPolygons, StayWithinTheBudget) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const double size = std::pow(10, -2 * uniform01(99, seed));
    const CleanOptions options{0.05 * size, 0.1 * size, 0.05 * size};
    LineSet raw = random_polygons(seed);
    LineSet lines = soup(seed, {});
    const LineSet polygons = raw;
    for (const InputLine& extra : lines.lines) raw.lines.push_back(extra);
    CleanedLines result;
    ASSERT_NO_THROW(result = clean_lines(raw, default_outline(raw, options.snap), options));
    expect_faithful(raw, result);
    ASSERT_NO_THROW(result = clean_lines(lines, boundary_outline(polygons, options.snap), options));
    expect_faithful(lines, result);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace quarry
