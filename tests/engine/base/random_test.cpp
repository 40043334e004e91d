#include "engine/base/random.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

TEST(Mix32, NeverGivesOneValueTwice) {
  // Runs of inputs from several places: ranks are drawn from consecutive positions.
  std::vector<std::uint32_t> outputs;
  for (const std::uint32_t start : {0U, 0x7fff0000U, 0xfff00000U})
    for (std::uint32_t i = 0; i < (1U << 19); ++i) outputs.push_back(mix32(start + i));
  std::sort(outputs.begin(), outputs.end());
  EXPECT_EQ(std::adjacent_find(outputs.begin(), outputs.end()), outputs.end());
}

TEST(Mix32, IsUndoneByTheInverseOfEachStep) {
  const auto inverse_of_odd = [](std::uint32_t odd) {
    std::uint32_t inverse = odd;
    for (int step = 0; step < 5; ++step) inverse *= 2 - odd * inverse;
    return inverse;
  };
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const std::uint32_t input = i * 42'949U;
    std::uint32_t x = mix32(input);
    x ^= x >> 16;
    x *= inverse_of_odd(0x846ca68bU);
    x ^= x >> 15 ^ x >> 30;
    x *= inverse_of_odd(0x7feb352dU);
    x ^= x >> 16;
    ASSERT_EQ(x, input);
  }
}

TEST(Mix32, ChangesHalfOfTheBitsWhenOneChanges) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    int changed = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) changed += std::popcount(mix32(i) ^ mix32(i ^ (1U << bit)));
    EXPECT_NEAR(changed / 1000.0, 16, 1) << "input bit " << bit;
  }
}

TEST(Uniform01, StaysBelowOneAndHasTheMeanOfAUniformDraw) {
  double sum = 0;
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const double value = uniform01(3, i);
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
  }
  EXPECT_NEAR(sum / 100'000, 0.5, 0.005);
}

}  // namespace
}  // namespace quarry
