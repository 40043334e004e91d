#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/matching/merge_cost.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/short_ways.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/subtree_parity.hpp"
#include "tests/kernels/matching/triangle_meshes.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

// Kruskal's: arcs from best to worst, ties by the smaller side.
DualArcs serial_forest(const Mesh& mesh, const std::vector<float>& worth) {
  std::vector<SideId> arcs;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (const SideId s(f, k); worth[s.value()] > kNoArc && s < mesh.neighbour(s)) arcs.push_back(s);
  std::sort(arcs.begin(), arcs.end(), [&](SideId a, SideId b) {
    return std::make_tuple(-worth[a.value()], a) < std::make_tuple(-worth[b.value()], b);
  });
  std::vector<std::size_t> parent(mesh.face_slots());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  DualArcs forest(mesh.face_slots(), 0);
  for (const SideId s : arcs) {
    const SideId t = mesh.neighbour(s);
    const std::size_t a = root(s.face().value()), b = root(t.face().value());
    if (a == b) continue;
    parent[a] = b;
    forest[s.face()] |= matching::bit_of(s.index());
    forest[t.face()] |= matching::bit_of(t.index());
  }
  return forest;
}

class SpanningForestOfSeeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SpanningForestOfSeeds, IsThatOfTheSerialGreedyOrderOnAnyNumberOfThreads) {
  SCOPED_TRACE(testing::Message() << "seed " << GetParam());
  // Without jitter most worths tie.
  const test::SyntheticMesh made = test::make_synthetic({.columns = 90,
                                                         .rows = 60,
                                                         .seed = GetParam(),
                                                         .jitter = GetParam() % 2 == 0 ? 0.0 : 0.4,
                                                         .straight_lines = 12,
                                                         .crooked_lines = 20});
  const std::vector<float> worth = pair_shapes(made.mesh, made.tags);
  const DualArcs expected = serial_forest(made.mesh, worth);
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const parallel::ParticipationProbe probe;
      const SpanningForest forest = maximum_spanning_forest(made.mesh, worth);
      EXPECT_EQ(forest.arcs.raw(), expected.raw());
      if (threads > 1) {
        EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SpanningForestOfSeeds, testing::Range<std::uint64_t>(1, 9));

TEST(SpanningForest, LabelsTheConnectedPartsOfTheDual) {
  const test::SyntheticMesh made = test::make_synthetic({.seed = 5, .crooked_lines = 30});
  const SpanningForest forest = maximum_spanning_forest(made.mesh, pair_shapes(made.mesh, made.tags));
  for (const FaceId f : made.mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (const SideId s(f, k); matching::joinable(made.mesh, made.tags, s)) {
        EXPECT_EQ(forest.root[f], forest.root[made.mesh.neighbour(s).face()]);
      }
}

TEST(SubtreeParity, GivesEveryTriangleOneOrThreeArcsOnAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Mesh mesh = test::delaunay_mesh(60, 47, seed);
    ASSERT_EQ(mesh.face_slots() % 2, 0U);
    const auto worth = pair_shapes(mesh, ConstraintTags::of(mesh));
    const DualArcs forest = maximum_spanning_forest(mesh, worth).arcs;
    const DualArcs expected = subtree_parity_join(mesh, forest);
    for (const FaceId f : mesh.faces()) EXPECT_EQ(matching::degree(expected[f]) % 2, 1);
    for (const int threads : {2, 4, 7})
      parallel::with_threads(threads, [&] {
        const parallel::ParticipationProbe probe;
        EXPECT_EQ(subtree_parity_join(mesh, forest).raw(), expected.raw());
      });
  }
}

TEST(SubtreeParity, HoldsOnAClosedSurface) {
  const Mesh mesh = test::icosphere(4);
  const auto worth = pair_shapes(mesh, ConstraintTags::of(mesh));
  const DualArcs join = subtree_parity_join(mesh, maximum_spanning_forest(mesh, worth).arcs);
  for (const FaceId f : mesh.faces()) EXPECT_EQ(matching::degree(join[f]) % 2, 1);
}

TEST(ShortWays, LeaveFewSteinerPointsAndAreTheSameOnAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Mesh mesh = test::delaunay_mesh(60, 47, seed);
    const auto shapes = pair_shapes(mesh, ConstraintTags::of(mesh));
    const auto expected = short_way_worths(mesh, shapes, {});
    const auto steiner_points = [&](const std::vector<float>& worth) {
      return count_steiner_points(subtree_parity_join(mesh, maximum_spanning_forest(mesh, worth).arcs));
    };
    EXPECT_LT(steiner_points(expected), steiner_points(shapes) / 3);
    for (const int threads : {1, 2, 4, 7})
      parallel::with_threads(threads, [&] {
        const parallel::ParticipationProbe probe;
        EXPECT_EQ(short_way_worths(mesh, shapes, {}), expected);
      });
  }
}

TEST(ShortWays, KeepThePairsOfALatticeOfRightTriangles) {
  // Every cell is a square, so that no way is needed; ties are everywhere.
  const Mesh mesh = test::with_fixed_rim(test::triangle_lattice(40, 30));
  const auto shapes = pair_shapes(mesh, ConstraintTags::of(mesh));
  const auto worth = short_way_worths(mesh, shapes, {});
  const DualArcs join = subtree_parity_join(mesh, maximum_spanning_forest(mesh, worth).arcs);
  EXPECT_EQ(count_steiner_points(join), 0U);
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (matching::contains(join, SideId(f, k))) {
        EXPECT_EQ(shapes[SideId(f, k).value()], 1.0F);
      }
}

}  // namespace
}  // namespace quarry
