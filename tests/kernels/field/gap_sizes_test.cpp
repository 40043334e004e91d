#include "kernels/field/gap_sizes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "tests/support/noded_lines.hpp"

namespace quarry {
namespace {

NodedLines lines_of(const std::vector<Segment>& segments) {
  NodedLines lines;
  for (const Segment& segment : segments) {
    lines.nodes.push_back(segment.from);
    lines.nodes.push_back(segment.to);
    const auto last = static_cast<std::uint32_t>(lines.nodes.size() - 1);
    lines.pieces.push_back({NodeId(last - 1), NodeId(last)});
  }
  return lines;
}

constexpr GapOptions kThree{.elements = 3, .smallest = 0.01, .largest = 2};

TEST(GapSizes, AskForElementsThatFitBetweenParallelLines) {
  const std::vector<SizeSource> sources =
      gap_sizes(lines_of({{{0, 0}, {20, 0}}, {{0, 1.5}, {20, 1.5}}}), kThree);
  ASSERT_FALSE(sources.empty());
  double covered = 0;
  for (const SizeSource& source : sources) {
    EXPECT_DOUBLE_EQ(source.size, 0.5);
    covered += distance(source.segment.from, source.segment.to);
  }
  EXPECT_NEAR(covered, 40, 1e-9);  // both lines
}

TEST(GapSizes, AskForNothingWhereLinesAreFarApart) {
  EXPECT_TRUE(gap_sizes(lines_of({{{0, 0}, {20, 0}}, {{0, 6.5}, {20, 6.5}}}), kThree).empty());
}

TEST(GapSizes, AskForNothingAlongOneLineInManyPieces) {
  std::vector<Segment> pieces;
  for (int i = 0; i < 40; ++i)
    pieces.push_back({{0.3 * i, 0.01 * (i % 2)}, {0.3 * i + 0.3, 0.01 * ((i + 1) % 2)}});
  EXPECT_TRUE(gap_sizes(lines_of(pieces), kThree).empty());
}

TEST(GapSizes, AskForNothingAtARightCrossing) {
  EXPECT_TRUE(
      gap_sizes(lines_of({{{0, 0}, {5, 0}}, {{5, 0}, {10, 0}}, {{5, 0}, {5, 5}}, {{5, 0}, {5, -5}}}), kThree)
          .empty());
}

TEST(GapSizes, FindAShortNarrowPlaceOfLongLines) {
  const std::vector<SizeSource> sources =
      gap_sizes(lines_of({{{0, 0}, {100, 0}}, {{37.2, 0.3}, {37.5, 0.3}}}), kThree);
  ASSERT_FALSE(sources.empty());
  for (const SizeSource& source : sources) EXPECT_LE(source.size, 0.35);
}

TEST(GapSizes, FollowAWedgeDownToTheSmallest) {
  const GapOptions options{.elements = 2, .smallest = 0.05, .largest = 1};
  const std::vector<SizeSource> sources =
      gap_sizes(lines_of({{{0, 0}, {20, 0}}, {{0, 0}, {20, 4}}}), options);
  ASSERT_FALSE(sources.empty());
  const auto [least, most] = std::minmax_element(
      sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.size < b.size; });
  EXPECT_DOUBLE_EQ(least->size, 0.05);
  EXPECT_GT(most->size, 0.8);
  EXPECT_LT(most->size, 1);
}

TEST(GapSizes, AreTheSameOnAnyNumberOfThreads) {
  std::vector<Segment> segments;
  for (int i = 0; i < 300; ++i) segments.push_back({{0.1 * i, 0}, {0.1 * i + 0.05, 10}});
  std::vector<SizeSource> serial;
  parallel::with_threads(1, [&] { serial = gap_sizes(lines_of(segments), kThree); });
  for (const int threads : {2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const std::vector<SizeSource> sources = gap_sizes(lines_of(segments), kThree);
      ASSERT_EQ(sources.size(), serial.size());
      for (std::size_t i = 0; i < sources.size(); ++i) {
        EXPECT_EQ(sources[i].segment.from, serial[i].segment.from);
        EXPECT_EQ(sources[i].size, serial[i].size);
      }
    });
  }
}

}  // namespace
}  // namespace quarry
