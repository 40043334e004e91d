#include "engine/geometry/grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

using Ids = std::vector<std::uint32_t>;

constexpr Vec2 kOrigin{6.7e6, 3e5};
constexpr Vec2 kCrowd = {kOrigin.x + 30, kOrigin.y + 40};
constexpr double kSpot = 1e-4;

std::vector<Vec2> random_points(std::size_t size, std::uint64_t seed) {
  std::vector<Vec2> points(size);
  for (std::size_t i = 0; i < size; ++i)
    points[i] = kOrigin + 100 * Vec2{uniform01(seed, 2 * i), uniform01(seed, 2 * i + 1)};
  return points;
}

// Most are short; one in ten runs through much of the box; some are level or upright.
std::vector<Segment> random_segments(std::size_t size, std::uint64_t seed) {
  const std::vector<Vec2> from = random_points(size, seed);
  const std::vector<Vec2> far = random_points(size, seed + 1);
  std::vector<Segment> segments(size);
  for (std::size_t i = 0; i < size; ++i) {
    segments[i] = {from[i], i % 10 == 0 ? far[i] : from[i] + 0.05 * (far[i] - from[i])};
    if (i % 7 == 0) segments[i].to.x = segments[i].from.x;
    if (i % 11 == 0) segments[i].to.y = segments[i].from.y;
  }
  return segments;
}

Box2 random_box(std::uint64_t counter) {
  const Vec2 low = kOrigin + 120 * Vec2{uniform01(9, 4 * counter) - 0.1, uniform01(9, 4 * counter + 1) - 0.1};
  return {low, low + 20 * Vec2{uniform01(9, 4 * counter + 2), uniform01(9, 4 * counter + 3)}};
}

bool meets(const Segment& s, const Box2& box) {
  if (box.contains(s.from) || box.contains(s.to)) return true;
  const Vec2 corners[4] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  for (int k = 0; k < 4; ++k)
    if (meeting(s.from, s.to, corners[k], corners[(k + 1) % 4]) != Meeting::kApart) return true;
  return false;
}

TEST(PointGrid, FindsWhatASearchOfAllPointsFinds) {
  const std::vector<Vec2> points = random_points(3000, 1);
  for (const double side : {0.01, 1.0, 7.0, 1000.0}) {
    const PointGrid grid(points, side);
    Ids found;
    for (std::uint64_t query = 0; query < 200; ++query) {
      const Box2 box = random_box(query);
      Ids expected;
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (box.contains(points[i])) expected.push_back(i);
      grid.find(box, found);
      ASSERT_EQ(found, expected) << "side " << side << ", query " << query;
    }
  }
}

TEST(PointGrid, TakesNoPointsRepeatedPointsAndBoxesElsewhere) {
  Ids found{1};
  PointGrid({}, 1).find({{0, 0}, {1, 1}}, found);
  EXPECT_TRUE(found.empty());
  const std::vector<Vec2> points(5, Vec2{3, 4});
  const PointGrid grid(points, 0.5);
  grid.find({{3, 4}, {3, 4}}, found);
  EXPECT_EQ(found, (Ids{0, 1, 2, 3, 4}));
  grid.find({{4, 4}, {5, 5}}, found);
  EXPECT_TRUE(found.empty());
  grid.find(Box2{}, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointGrid, LooksAtFewWhereNearlyAllLieInOneSpot) {
  std::vector<Vec2> points = random_points(20'000, 5);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i % 1000 != 0) points[i] = kCrowd + kSpot * (points[i] - kOrigin);
  const PointGrid grid(points, 1e-8);
  std::size_t looks = 0;
  Ids found;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Box2 box = Box2{points[i], points[i]}.grown(1e-8);
    grid.visit_near(box, [&](std::uint32_t) { ++looks; });
    grid.find(box, found);
    ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i));
  }
  EXPECT_LT(looks, 100 * points.size());
  const auto order = grid.by_cells();
  Ids all(order.begin(), order.end());
  std::sort(all.begin(), all.end());
  ASSERT_EQ(all.size(), points.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], i);
}

TEST(SegmentGrid, MissesNoSegmentThatMeetsTheBox) {
  const std::vector<Segment> segments = random_segments(1000, 2);
  for (const double side : {0.01, 1.0, 7.0, 1000.0}) {
    const SegmentGrid grid(segments, side);
    Ids found;
    for (std::uint64_t query = 0; query < 200; ++query) {
      const Box2 box = random_box(query);
      grid.find(box, found);
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      for (std::uint32_t i = 0; i < segments.size(); ++i)
        if (meets(segments[i], box)) {
          ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i))
              << "segment " << i << ", query " << query;
        }
    }
  }
}

TEST(SegmentGrid, MissesNoSegmentThatTouchesTheBoxOnACellBorder) {
  // Ends, boxes and cell borders all on multiples of 0.1, where rounding decides which cell is which.
  std::vector<Segment> segments;
  const auto at = [](int x, int y) { return kOrigin + Vec2{0.1 * x, 0.1 * y}; };
  for (std::uint64_t i = 0; i < 500; ++i) {
    const auto draw = [&](std::uint64_t k) { return static_cast<int>(30 * uniform01(4, 4 * i + k)); };
    segments.push_back({at(draw(0), draw(1)), at(draw(2), draw(3))});
  }
  const SegmentGrid grid(segments, 0.1);
  Ids found;
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 30; ++y) {
      const Box2 box{at(x, y), at(x, y)};
      grid.find(box, found);
      for (std::uint32_t i = 0; i < segments.size(); ++i)
        if (on_segment(box.low, segments[i].from, segments[i].to)) {
          ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i)) << "segment " << i;
        }
    }
  }
}

TEST(SegmentGrid, LooksOnlyNearTheBox) {
  const std::vector<Segment> segments = random_segments(1000, 2);
  const SegmentGrid grid(segments, 1);
  Ids found;
  grid.find({kOrigin + Vec2{50, 50}, kOrigin + Vec2{51, 51}}, found);
  EXPECT_LT(found.size(), 60U);
}

// Nearly all of them in a spot of a ten thousandth of the box, among them a bundle that runs through all of
// it.
std::vector<Segment> crowded_segments(std::size_t size, std::uint64_t seed) {
  std::vector<Segment> segments = random_segments(size, seed);
  for (std::size_t i = 0; i < size; ++i) {
    if (i % 50 == 0) continue;
    Segment& s = segments[i];
    s = {kCrowd + kSpot * (s.from - kOrigin), kCrowd + kSpot * (s.to - kOrigin)};
    if (i % 199 == 0) s.to = s.from + Vec2{60, 3};
  }
  return segments;
}

TEST(SegmentGrid, MissesNoSegmentWhereNearlyAllLieInOneSpot) {
  const std::vector<Segment> segments = crowded_segments(1000, 12);
  const SegmentGrid grid(segments, 1e-7);
  Ids found;
  for (std::uint64_t query = 0; query < 400; ++query) {
    Box2 box = random_box(query);
    if (query % 4 != 0) box = {kCrowd + kSpot * (box.low - kOrigin), kCrowd + kSpot * (box.high - kOrigin)};
    grid.find(box, found);
    ASSERT_EQ(std::adjacent_find(found.begin(), found.end(), std::greater_equal<>()), found.end());
    Ids along;
    grid.visit_along({box.low, box.high}, [&](std::uint32_t id) { along.push_back(id); });
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      if (meets(s, box)) {
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i)) << "query " << query << ", " << i;
      }
      if (meeting(box.low, box.high, s.from, s.to) != Meeting::kApart) {
        ASSERT_NE(std::find(along.begin(), along.end(), i), along.end()) << "query " << query << ", " << i;
      }
    }
  }
}

TEST(SegmentGrid, HasACellForEachPairThatMeetsWhereNearlyAllLieInOneSpot) {
  const std::vector<Segment> segments = crowded_segments(1000, 13);
  const SegmentGrid grid(segments, 1e-7);
  std::set<std::pair<std::uint32_t, std::uint32_t>> together;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto entries = grid.entries(cell);
    ASSERT_TRUE(std::is_sorted(entries.begin(), entries.end()));
    for (const std::uint32_t a : entries)
      for (const std::uint32_t b : entries) together.emplace(a, b);
  }
  for (std::uint32_t a = 0; a < segments.size(); ++a) {
    for (std::uint32_t b = 0; b < a; ++b) {
      const bool meet =
          meeting(segments[a].from, segments[a].to, segments[b].from, segments[b].to) != Meeting::kApart;
      ASSERT_TRUE(!meet || together.contains({a, b})) << a << " and " << b;
    }
  }
}

TEST(SegmentGrid, LooksAtFewWhereNearlyAllLieInOneSpot) {
  const std::vector<Segment> segments = crowded_segments(20'000, 14);
  const SegmentGrid grid(segments, 1e-8);
  std::size_t pairs = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    pairs += grid.entries(cell).size() * grid.entries(cell).size();
  // Most of them of the bundle, in each cell that it runs through. Without a split there are fifty times as
  // many.
  EXPECT_LT(pairs, 16'000'000U);
}

TEST(SegmentGrid, FindsTheSameOnAnyNumberOfThreads) {
  const std::vector<Segment> segments = random_segments(50'000, 3);
  const auto find_all = [&](int threads) {
    std::vector<Ids> all(50);
    parallel::with_threads(threads, [&] {
      const SegmentGrid grid(segments, 0.5);
      for (std::uint64_t query = 0; query < all.size(); ++query) grid.find(random_box(query), all[query]);
    });
    return all;
  };
  const std::vector<Ids> expected = find_all(1);
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    EXPECT_EQ(find_all(threads), expected);
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

}  // namespace
}  // namespace quarry
