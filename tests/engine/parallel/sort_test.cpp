#include "engine/parallel/sort.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::parallel {
namespace {

std::vector<std::uint64_t> random_keys(std::size_t size, std::uint64_t mask) {
  std::vector<std::uint64_t> keys(size);
  for (std::size_t i = 0; i < size; ++i) keys[i] = mix64(i + 1) & mask;
  return keys;
}

void expect_sorted(const std::vector<std::uint64_t>& keys, const std::string& what) {
  std::vector<std::uint32_t> expected(keys.size());
  std::iota(expected.begin(), expected.end(), 0U);
  std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  for (const int threads : {1, 4})
    with_threads(threads,
                 [&] { EXPECT_EQ(sorted_order(keys), expected) << keys.size() << " keys, " << what; });
}

TEST(SortedOrder, EqualsStdStableSortForAnyWidthOfKeysAndNumberOfThreads) {
  for (const std::size_t size : {0UL, 1UL, 100UL, 20'000UL, 1'100'000UL})
    for (const std::uint64_t mask : {~0ULL, 0x3ffULL, 0xff00ff00ULL, 0x3ff0000ffffULL, 0ULL})
      expect_sorted(random_keys(size, mask), "mask " + std::to_string(mask));
}

TEST(SortedOrder, EqualsStdStableSortWhereTheHighestDigitsAreTheSameOfNearlyAll) {
  for (const std::size_t size : {20'000UL, 1'100'000UL}) {
    std::vector<std::uint64_t> keys = random_keys(size, 0xffffff);
    for (std::size_t i = 0; i < size; i += 10) keys[i] <<= 30;
    expect_sorted(keys, "one in ten far above the others");
  }
}

TEST(OrderedBits, SortLikeTheDoubles) {
  const std::vector<double> values{-1e300, -2.5, -1e-300, 0.0, 1e-300, 3.0, 1e300};
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end(),
                             [](double a, double b) { return ordered_bits(a) < ordered_bits(b); }));
}

}  // namespace
}  // namespace quarry::parallel
