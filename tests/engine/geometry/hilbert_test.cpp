#include "engine/geometry/hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

TEST(HilbertKey, OrdersALatticeSoThatNextIsAlwaysOneCellAway) {
  for (const int side : {1, 2, 16, 128}) {
    // Cell centres, so that the lattice is a subdivision of the box whatever the order of the curve.
    const Box2 box{{6.7e6, -300}, {6.7e6 + side, -300.0 + side}};
    std::vector<Vec2> points;
    std::vector<std::uint64_t> keys;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) points.push_back({box.low.x + x + 0.5, box.low.y + y + 0.5});
    for (const Vec2 point : points) keys.push_back(hilbert_key(point, box));
    const std::vector<std::uint32_t> order = parallel::sorted_order(keys);
    for (std::size_t i = 1; i < order.size(); ++i)
      ASSERT_EQ(distance(points[order[i - 1]], points[order[i]]), 1) << "side " << side << ", position " << i;
  }
}

TEST(HilbertKey, OrdersALatticeInSpaceSoThatNextIsAlwaysOneCellAway) {
  for (const int side : {2, 4, 16}) {
    const Box3 box{{0, 0, 0}, {1.0 * side, 1.0 * side, 1.0 * side}};
    std::vector<Vec3> points;
    std::vector<std::uint64_t> keys;
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) points.push_back({x + 0.5, y + 0.5, z + 0.5});
    for (const Vec3 point : points) keys.push_back(hilbert_key(point, box));
    const std::vector<std::uint32_t> order = parallel::sorted_order(keys);
    for (std::size_t i = 1; i < order.size(); ++i)
      ASSERT_EQ(length(points[order[i]] - points[order[i - 1]]), 1) << "side " << side << ", position " << i;
  }
}

TEST(HilbertKey, DiffersByOneBetweenNeighboursAtItsFullDepth) {
  // One cell of the finest lattice is one unit here. A cell and its neighbours along the curve: two of the
  // four cells around it have keys that differ by one, except at the ends of the curve.
  const double cells = std::ldexp(1, kHilbertOrder2);
  const Box2 box{{0, 0}, {cells, cells}};
  const Vec2 middle{123'456'789.5, 98'765'432.5};
  const std::uint64_t key = hilbert_key(middle, box);
  int next = 0;
  for (const Vec2 step : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
    const std::uint64_t other = hilbert_key(middle + step, box);
    if (other == key + 1 || other + 1 == key) ++next;
  }
  EXPECT_EQ(next, 2);
}

TEST(HilbertKey, ClampsPointsOutsideAndTakesABoxOfNoExtent) {
  const Box2 box{{0, 0}, {2, 1}};
  EXPECT_EQ(hilbert_key(Vec2{-5, -5}, box), hilbert_key(Vec2{0, 0}, box));
  EXPECT_EQ(hilbert_key(Vec2{7, 0}, box), hilbert_key(Vec2{2, 0}, box));
  EXPECT_EQ(hilbert_key(Vec2{3, 4}, Box2{{3, 4}, {3, 4}}), 0U);
  EXPECT_EQ(hilbert_key(Vec2{3, 4}, Box2{}), 0U);
}

}  // namespace
}  // namespace quarry
