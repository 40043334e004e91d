#include "kernels/linework/nearest_course.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/geometry/segment.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry::linework {
namespace {

const std::vector<Vec2> kHairpin{{0, 0}, {20, 0}, {20, 6}, {0, 6}};

// A path along a raw line by these nodes, at these parameters.
PathNetwork network_of(const std::vector<Vec2>& raw, const std::vector<Vec2>& nodes,
                       const std::vector<double>& parameters) {
  PathNetwork network;
  network.raw.push_back({raw, LineId(0U)});
  for (const Vec2 p : nodes) (void)network.nodes.push_back(p);
  Path path;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    path.steps.push_back({NodeId(static_cast<std::uint32_t>(i)), parameters[i]});
  network.paths.push_back(path);
  return network;
}

std::vector<std::uint32_t> nodes_of(const std::vector<PathStep>& steps) {
  std::vector<std::uint32_t> nodes;
  for (const PathStep& step : steps) nodes.push_back(step.node.value());
  return nodes;
}

// Slanting, level, upright, without length, and so long that all nodes are looked at.
TEST(NodeBuckets, VisitEveryNodeNearASegment) {
  constexpr double kRadius = 0.3;
  Dice dice(7);
  NodeBuckets buckets({3, -2}, kRadius);
  std::vector<Vec2> points;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    points.push_back({dice(-20, 20), dice(-20, 20)});
    buckets.insert(NodeId(i), points.back());
  }
  for (int round = 0; round < 500; ++round) {
    const Vec2 a{dice(-20, 20), dice(-20, 20)};
    const double reach = round % 5 == 4 ? 1e5 : 15;
    Vec2 b = a + Vec2{dice(-reach, reach), dice(-reach, reach)};
    if (round % 5 == 1) b.y = a.y;
    if (round % 5 == 2) b.x = a.x;
    if (round % 50 == 3) b = a;
    std::vector<std::uint8_t> visited(points.size(), 0);
    buckets.visit_along(a, b, [&](NodeId node, Vec2 at) {
      EXPECT_EQ(at, points[node.value()]);
      visited[node.value()] = 1;
    });
    for (std::size_t i = 0; i < points.size(); ++i)
      if (squared_distance(points[i], a, b) < kRadius * kRadius) {
        EXPECT_EQ(visited[i], 1) << "seed 7, round " << round << ", node " << i;
      }
  }
}

TEST(NearestCourse, HoldsTheNodesBesideTheStretchInItsOrder) {
  PathNetwork network =
      network_of(kHairpin, {{0, 0}, {20, 0}, {15, 0.5}, {5, -0.5}, {10, 2}, {0.5, 6}, {30, 0}}, {0, 1});
  const NodePlaces places(network, 1);
  EXPECT_EQ(nodes_of(nearest_course(places, kHairpin, 0, 1)), (std::vector<std::uint32_t>{3, 2}));
  EXPECT_EQ(nodes_of(nearest_course(places, kHairpin, 0, 3)), (std::vector<std::uint32_t>{3, 2, 1, 5}));
}

TEST(NearestCourse, ComesTwiceByANodeThatTheLineComesBackTo) {
  PathNetwork network = network_of(kHairpin, {{0, 0}, {10, 3}, {0, 6}}, {0, 1.5, 3});
  const NodePlaces places(network, 4);
  EXPECT_EQ(nodes_of(nearest_course(places, kHairpin, 0, 3)), (std::vector<std::uint32_t>{1, 1}));
}

TEST(PinCourse, MakesNodesAtVerticesAndAroundStepsThatWereLedAstray) {
  PathNetwork network = network_of(kHairpin, {{0, 0}, {10, 1.5}, {20, 6}}, {0, 0.5, 2});
  NodePlaces places(network, 1);
  pin_course(places, network, network.paths[0], {0, 2});
  EXPECT_TRUE(places.nearest({20, 0}).valid());
  for (const double x : {8.2, 9.0, 10.0, 11.0, 11.8}) EXPECT_TRUE(places.nearest({x, 0}).valid()) << x;
  for (const double x : {5.0, 15.0}) EXPECT_FALSE(places.nearest({x, 0}).valid()) << x;
}

TEST(PinCourse, MakesNoNodeWhereThePathKeptToItsLine) {
  PathNetwork network = network_of(kHairpin, {{0, 0}, {10, 0.5}, {20, 0}}, {0, 0.5, 1});
  NodePlaces places(network, 1);
  pin_course(places, network, network.paths[0], {0, 2});
  EXPECT_EQ(network.nodes.size(), 3U);
}

}  // namespace
}  // namespace quarry::linework
