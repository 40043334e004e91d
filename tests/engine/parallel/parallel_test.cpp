#include "engine/parallel/parallel.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace quarry::parallel {
namespace {

double sum_of_harmonics(std::size_t size) {
  return reduce_ordered(
      size, 0.0,
      [](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += 1.0 / static_cast<double>(i + 1);
        return sum;
      },
      [](double a, double b) { return a + b; });
}

TEST(ForEach, VisitsEachIndexOnce) {
  std::vector<int> visits(100'003, 0);
  for_each(visits.size(), [&](std::size_t i) { ++visits[i]; });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(visits.size()));
}

TEST(ReduceOrdered, GivesTheSameBitsOnAnyNumberOfThreadsWhileOthersTakePart) {
  constexpr std::size_t kSize = 200'000;
  double serial = 0;
  with_threads(1, [&] { serial = sum_of_harmonics(kSize); });
  for (const int threads : {2, 4, 7}) {
    const ParticipationProbe probe(200);
    double other = 0;
    with_threads(threads, [&] { other = sum_of_harmonics(kSize); });
    EXPECT_EQ(serial, other) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST(ExclusiveScan, EqualsTheSerialScan) {
  std::vector<std::uint32_t> values(300'001);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint32_t>(i * 7 % 11);
  std::vector<std::uint32_t> expected(values.size());
  std::exclusive_scan(values.begin(), values.end(), expected.begin(), 0U);
  const std::uint32_t total = std::accumulate(values.begin(), values.end(), 0U);
  EXPECT_EQ(exclusive_scan(std::span(values)), total);
  EXPECT_EQ(values, expected);
}

TEST(FilterIndices, AsksAboutEachOnce) {
  constexpr std::size_t kSize = 10'007;  // no multiple of a word
  std::vector<int> asked(kSize, 0);
  const auto kept = filter_indices(kSize, [&](std::size_t i) { return ++asked[i] == 1; });
  EXPECT_EQ(kept.size(), kSize);
  EXPECT_EQ(asked, std::vector<int>(kSize, 1));
}

TEST(FilterIndices, KeepsOrder) {
  const auto kept = filter_indices(100'000, [](std::size_t i) { return i % 3 == 1; });
  ASSERT_EQ(kept.size(), 33'333U);
  for (std::size_t i = 0; i < kept.size(); ++i) ASSERT_EQ(kept[i], 3 * i + 1);
}

TEST(Isolated, KeepsAThreadThatWaitsFromStartingAnotherChunkOfTheLoopOutside) {
  static thread_local int inside = 0;
  std::vector<int> nested(200, 0);
  with_threads(4, [&] {
    for_each(
        nested.size(),
        [&](std::size_t i) {
          nested[i] = inside++;
          isolated([&] {
            for_each(
                64, [](std::size_t k) { (void)sum_of_harmonics(1000 + k); }, 1);
          });
          --inside;
        },
        1);
  });
  EXPECT_EQ(std::count(nested.begin(), nested.end(), 0), 200);
}

TEST(WithThreads, PassesExceptionsOn) {
  EXPECT_THROW(with_threads(4,
                            [] {
                              for_each(100'000, [](std::size_t i) {
                                if (i == 77'777) throw 1;
                              });
                            }),
               int);
}

}  // namespace
}  // namespace quarry::parallel
