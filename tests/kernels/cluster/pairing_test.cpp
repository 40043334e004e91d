#include "kernels/cluster/pairing.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/merge.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

// All allowed pairs sorted, best first; each is taken if both triangles are still free.
Pairing serial_greedy(const Mesh& mesh, ConstraintTags tags, const PairingOptions& options) {
  Pairing pairing;
  pairing.merged.resize(mesh.face_slots());
  for (int pass = 0; pass < pairing_passes(options); ++pass) {
    std::vector<std::pair<float, SideId>> pairs;
    for (const FaceId f : mesh.faces()) {
      for (int k = 0; k < 3; ++k) {
        const SideId s(f, k);
        const SideId t = mesh.neighbour(s);
        if (!t.valid() || t < s) continue;
        if (const float worth = pair_worth(mesh, tags, s, pass, options); worth >= 0)
          pairs.emplace_back(worth, s);
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return std::make_tuple(-a.first, a.second) < std::make_tuple(-b.first, b.second);
    });
    for (const auto& [worth, s] : pairs) {
      const SideId t = mesh.neighbour(s);
      if (pairing.merged[s.face()].valid() || pairing.merged[t.face()].valid()) continue;
      pairing.merged[s.face()] = s;
      pairing.merged[t.face()] = t;
    }
  }
  return pairing;
}

class GreedyPairing : public testing::TestWithParam<std::tuple<PairMeasure, std::uint64_t>> {};

TEST_P(GreedyPairing, EqualsTheSerialGreedyOrderOnAnyNumberOfThreads) {
  const auto [measure, seed] = GetParam();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  // Without jitter all lengths tie; with it none does.
  const test::SyntheticMesh made =
      test::make_synthetic({.columns = 90, .rows = 40, .seed = seed, .jitter = seed % 2 == 0 ? 0.0 : 0.4});
  const PairingOptions options{.measure = measure};
  const Pairing expected = serial_greedy(made.mesh, made.tags, options);
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const parallel::ParticipationProbe probe;
      PairingReport report;
      const Pairing got = pair_triangles(made.mesh, made.tags, options, report, Progress());
      EXPECT_EQ(got.merged.raw(), expected.merged.raw());
      EXPECT_EQ(2 * report.pairs + report.singles, made.mesh.face_slots());
      if (threads > 1) {
        EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GreedyPairing,
                         testing::Combine(testing::Values(PairMeasure::kLongestEdge,
                                                          PairMeasure::kQuadQuality),
                                          testing::Range<std::uint64_t>(1, 9)));

TEST(Pairing, ReturnsTheCellsOfAnUntouchedLattice) {
  const test::SyntheticMesh made =
      test::make_synthetic({.jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
  PairingReport report;
  (void)pair_triangles(made.mesh, made.tags, {}, report, Progress());
  EXPECT_EQ(report.singles, 0U);
}

TEST(Pairing, NeverMergesAcrossAConstraint) {
  const test::SyntheticMesh made = test::make_synthetic({.straight_lines = 12, .crooked_lines = 20});
  PairingReport report;
  const Pairing pairing = pair_triangles(made.mesh, made.tags, {}, report, Progress());
  for (const SideId s : pairing.merged) EXPECT_FALSE(s.valid() && made.tags.constrained(s));
}

TEST(Merge, KeepsConnectivityAndConstraintsOfEverySyntheticMesh) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.seed = seed});
    std::size_t constrained = 0;
    for (const FaceId f : made.mesh.faces())
      for (int k = 0; k < 3; ++k) constrained += made.tags.constrained(SideId(f, k)) ? 1 : 0;
    PairingReport report;
    const Pairing pairing = pair_triangles(made.mesh, made.tags, {}, report, Progress());
    const Mesh mixed = merge_pairs(std::move(made.mesh), pairing);
    EXPECT_EQ(validate(mixed, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(mixed.face_slots(), report.pairs + report.singles);
    const ConstraintTags tags = ConstraintTags::of(mixed);
    std::size_t kept = 0;
    for (const FaceId f : mixed.faces()) {
      for (int k = 0; k < mixed.corner_count(f); ++k) {
        const SideId s(f, k);
        kept += tags.constrained(s) ? 1 : 0;
        const SideId across = mixed.neighbour(s);
        EXPECT_TRUE(!across.valid() || tags.constrained(s) == tags.constrained(across));
      }
    }
    EXPECT_EQ(kept, constrained);
  }
}

}  // namespace
}  // namespace quarry
