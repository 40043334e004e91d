#include "kernels/field/graded_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/geometry/segment.hpp"

namespace quarry {
namespace {

std::vector<SizeSource> random_sources(std::uint64_t seed, Vec2 origin) {
  std::vector<SizeSource> sources;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const auto draw = [&](std::uint64_t k) { return uniform01(seed, 5 * i + k); };
    const Vec2 a{origin.x + 100 * draw(0), origin.y + 100 * draw(1)};
    const Vec2 b = i % 3 == 0 ? a : a + Vec2{10 * draw(2), 10 * draw(3)};
    sources.push_back({{a, b}, 0.1 + 2 * draw(4)});
  }
  return sources;
}

TEST(GradedSize, EqualsTheSmallestOverAllSources) {
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Vec2 origin = seed == 3 ? Vec2{465'000, 6'691'000} : Vec2{0, 0};
    const std::vector<SizeSource> sources = random_sources(seed, origin);
    const GradedSize field(sources, {.largest = 5, .gradation = 0.2});
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Vec2 p{origin.x - 50 + 200 * uniform01(9, 2 * i), origin.y - 50 + 200 * uniform01(9, 2 * i + 1)};
      double expected = 5;
      for (const auto& [segment, size, reach] : sources) {
        const double away = std::sqrt(squared_distance(p, segment.from, segment.to));
        expected = std::min(expected, size + 0.2 * std::max(0.0, away - reach));
      }
      ASSERT_EQ(field.at(p), expected);
    }
  }
}

TEST(GradedSize, IsNowhereSteeperThanTheGradation) {
  const GradedSize field(random_sources(4, {0, 0}), {.largest = 5, .gradation = 0.3});
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Vec2 p{100 * uniform01(1, 4 * i), 100 * uniform01(1, 4 * i + 1)};
    const Vec2 q{100 * uniform01(1, 4 * i + 2), 100 * uniform01(1, 4 * i + 3)};
    EXPECT_LE(std::abs(field.at(p) - field.at(q)), 0.3 * distance(p, q) + 1e-12);
  }
}

TEST(GradedSize, IsTheLargestSizeWhereNothingIsAskedFor) {
  EXPECT_EQ(GradedSize({}, {.largest = 3}).at({1, 2}), 3);
  EXPECT_EQ(GradedSize({{{{0, 0}, {0, 0}}, 0.1}}, {.largest = 3}).at({1e6, 1e6}), 3);
}

TEST(GradedSize, HoldsUpToItsReach) {
  const GradedSize field({{{{0, 0}, {10, 0}}, 1, 3}}, {.largest = 50, .gradation = 0.5});
  EXPECT_EQ(field.at({5, 2.9}), 1);
  EXPECT_EQ(field.at({5, 7}), 3);
  EXPECT_EQ(field.at({18, 0}), 3.5);
}

TEST(GradedSize, RefusesSizesThatAreNotPositive) {
  EXPECT_THROW(GradedSize({{{{0, 0}, {0, 0}}, 0}}, {}), Error);
  EXPECT_THROW(GradedSize({{{{0, 0}, {0, 0}}, 1, -1}}, {}), Error);
  EXPECT_THROW(GradedSize({}, {.largest = std::nan("")}), Error);
  EXPECT_THROW(GradedSize({}, {.largest = 1, .gradation = 0}), Error);
}

TEST(UniformSize, IsTheSameEverywhere) { EXPECT_EQ(UniformSize(2.5).at({7, 8}), 2.5); }

}  // namespace
}  // namespace quarry
