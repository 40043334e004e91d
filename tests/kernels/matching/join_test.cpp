#include <vector>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/matching/join_search.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/star_toggle.hpp"
#include "kernels/matching/subtree_parity.hpp"
#include "tests/kernels/matching/triangle_meshes.hpp"

namespace quarry {
namespace {

using matching::SearchState;
using matching::StarToggle;

DualArcs start_of(const Mesh& mesh) {
  const auto worth = pair_shapes(mesh, ConstraintTags::of(mesh));
  return subtree_parity_join(mesh, maximum_spanning_forest(mesh, worth).arcs);
}

// The cost of a join by its definition, face by face.
long cost_of(const Mesh& mesh, const MergeCosts& costs, const DualArcs& join, const SearchState& state) {
  long cost = 0;
  for (const FaceId f : mesh.faces()) {
    if (matching::is_split(join[f])) cost += costs.steiner();
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (!matching::contains(join, s) || mesh.neighbour(s) < s) continue;
      cost += costs(s, matching::is_split(join[f]), matching::is_split(join[mesh.neighbour(s).face()]));
    }
  }
  for (const VertexId v : mesh.vertices()) {
    if (state.ideal[v] == 0) continue;
    const long error = state.valence[v] - state.ideal[v];
    cost += error * error * costs.valence();
  }
  return cost;
}

TEST(StarToggle, ForetellsTheChangeInCostAndKeepsDegreesOdd) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Mesh mesh = test::delaunay_mesh(14, 12, seed);
    const ConstraintTags tags = ConstraintTags::of(mesh);
    const MergeCosts costs(mesh, pair_shapes(mesh, tags), {});
    DualArcs join = start_of(mesh);
    SearchState state(mesh, tags, costs, join);
    StarToggle toggle(state);
    for (const VertexId v : mesh.vertices()) {
      if (state.free[v] == 0) continue;
      const VertexId w = mesh.target(mesh.side_of(v));
      const bool pair = v.value() % 2 == 0 && state.free[w] != 0;
      const long before = cost_of(mesh, costs, join, state);
      toggle.gather({v, pair ? w : VertexId()});
      const int change = toggle.gain_in_cost();
      toggle.commit();
      // The kept valences are those of a state made anew.
      DualArcs copy = join;
      const SearchState fresh(mesh, tags, costs, copy);
      EXPECT_EQ(fresh.valence.raw(), state.valence.raw());
      EXPECT_EQ(cost_of(mesh, costs, join, state), before + change);
    }
    for (const FaceId f : mesh.faces()) EXPECT_EQ(matching::degree(join[f]) % 2, 1);
  }
}

class Search : public testing::TestWithParam<int> {};

TEST_P(Search, LowersTheCostAndIsTheSameOnAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Mesh mesh = test::delaunay_mesh(60, 41, seed);
    const ConstraintTags tags = ConstraintTags::of(mesh);
    const MergeCosts costs(mesh, pair_shapes(mesh, tags), {});
    const DualArcs start = start_of(mesh);
    const JoinSearchOptions options{.annealing_sweeps = GetParam()};
    DualArcs expected;
    for (const int threads : {1, 2, 4, 7}) {
      parallel::with_threads(threads, [&] {
        const parallel::ParticipationProbe probe;
        DualArcs join = start;
        JoinSearchReport report;
        improve_join(mesh, tags, costs, options, join, report, Progress());
        if (threads == 1) expected = join;
        EXPECT_EQ(join.raw(), expected.raw());
        if (threads > 1) {
          EXPECT_GT(probe.chunks_of_other_threads(), 0U);
        }
      });
    }
    DualArcs before = start, after = expected;
    const SearchState first(mesh, tags, costs, before), last(mesh, tags, costs, after);
    EXPECT_LT(cost_of(mesh, costs, after, last), cost_of(mesh, costs, before, first));
    EXPECT_LT(count_steiner_points(after), count_steiner_points(before) / 3);
    for (const FaceId f : mesh.faces()) EXPECT_EQ(matching::degree(after[f]) % 2, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(AnnealingSweeps, Search, testing::Values(0, 20));

}  // namespace
}  // namespace quarry
