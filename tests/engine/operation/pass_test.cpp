#include "engine/operation/pass.hpp"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/engine/operation/test_operations.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

using test::BisectLongEdges;
using test::edges_of;
using test::FlipToDelaunay;
using test::QueueAtOneVertex;
using test::trial_mesh;
using test::TrialMesh;

struct Outcome {
  std::vector<std::uint64_t> arrays;
  PassReport report;
  std::uint64_t applied = 0;
  std::string failure;
};

bool same(const PassReport& a, const PassReport& b) {
  return a.rounds == b.rounds && a.proposed == b.proposed && a.live == b.live && a.won == b.won;
}

Outcome flip_all(PassOptions options) {
  TrialMesh trial = trial_mesh(60, 7);
  const FlipToDelaunay operation(trial.tags, false);
  Outcome outcome;
  outcome.report = run_pass(trial.mesh, operation, edges_of(trial.mesh), options, Progress());
  outcome.arrays = test::arrays_of(trial.mesh);
  outcome.applied = operation.applied();
  outcome.failure = validate(trial.mesh, GeometryCheck::kPlanarCorners);
  return outcome;
}

Outcome bisect_all(PassOptions options) {
  TrialMesh trial = trial_mesh(30, 8);
  const BisectLongEdges operation(trial.tags, 0.4);
  Outcome outcome;
  outcome.report = run_pass(trial.mesh, operation, edges_of(trial.mesh), options, Progress());
  outcome.arrays = test::arrays_of(trial.mesh);
  outcome.applied = operation.applied();
  outcome.failure = validate(trial.mesh, GeometryCheck::kPlanarCorners);
  EXPECT_EQ(trial.mesh.count_alive_faces(), trial.mesh.face_slots());
  EXPECT_EQ(trial.mesh.count_alive_vertices(), trial.mesh.vertex_slots());
  return outcome;
}

template <class Job>
void expect_same_on_any_number_of_threads(Job&& job) {
  Outcome serial;
  parallel::with_threads(1, [&] { serial = job(PassOptions{}); });
  EXPECT_EQ(serial.failure, "");
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    Outcome other;
    parallel::with_threads(threads, [&] { other = job(PassOptions{}); });
    EXPECT_EQ(other.arrays, serial.arrays) << threads << " threads";
    EXPECT_TRUE(same(other.report, serial.report)) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST(Pass, FlipsTheSameEdgesOnAnyNumberOfThreads) {
  expect_same_on_any_number_of_threads([](PassOptions options) { return flip_all(options); });
}

TEST(Pass, BisectsTheSameEdgesOnAnyNumberOfThreads) {
  expect_same_on_any_number_of_threads([](PassOptions options) { return bisect_all(options); });
}

TEST(Pass, DoesNotCareInWhichOrderWinnersApply) {
  for (const std::size_t window : {std::size_t{512}, std::size_t{16384}}) {
    EXPECT_EQ(flip_all({.window = window}).arrays, flip_all({.window = window, .reverse = true}).arrays);
    EXPECT_EQ(bisect_all({.window = window}).arrays, bisect_all({.window = window, .reverse = true}).arrays);
  }
}

TEST(Pass, LeavesNothingUndoneWhateverTheWindowAndTheCutoff) {
  for (const PassOptions options :
       {PassOptions{.window = 1, .cutoff = 1}, PassOptions{.window = 100, .cutoff = 1},
        PassOptions{.window = 2000, .cutoff = 16}}) {
    TrialMesh trial = trial_mesh(20, 9);
    const FlipToDelaunay operation(trial.tags, false);
    run_pass(trial.mesh, operation, edges_of(trial.mesh), options, Progress());
    std::vector<VertexId> storage;
    for (const test::EdgeItem edge : edges_of(trial.mesh)) {
      Cavity cavity(storage);
      test::NoPlan plan;
      EXPECT_FALSE(operation.propose(trial.mesh, edge, cavity, plan));
    }
  }
}

TEST(Pass, IsNotHinderedByClaimsOfPassesBefore) {
  Claims claims;
  const auto flip_with = [](Claims& kept) {
    TrialMesh trial = trial_mesh(60, 7);
    const FlipToDelaunay operation(trial.tags, false);
    run_pass(trial.mesh, operation, edges_of(trial.mesh), {}, Progress(), kept);
    return test::arrays_of(trial.mesh);
  };
  const auto first = flip_with(claims);
  EXPECT_EQ(first, flip_all({}).arrays);
  EXPECT_EQ(flip_with(claims), first);
}

TEST(Pass, CountsWhatItDid) {
  const Outcome flips = flip_all({});
  EXPECT_EQ(flips.report.won, flips.applied);
  EXPECT_GT(flips.report.won, 500U);
  EXPECT_LE(flips.report.won, flips.report.live);
  EXPECT_LE(flips.report.live, flips.report.proposed);
  EXPECT_GT(flips.report.rounds, 1U);
  const Outcome halves = bisect_all({});
  EXPECT_EQ(halves.report.won, halves.applied);
}

TEST(Pass, AdvancesInEveryRoundEvenIfAllWantTheSameVertex) {
  for (const PassOptions options : {PassOptions{.cutoff = 1}, PassOptions{.cutoff = 4}}) {
    Mesh mesh = test::one_triangle();
    const QueueAtOneVertex operation(nullptr, 0);
    std::vector<std::uint32_t> work(3000);
    std::iota(work.begin(), work.end(), 0U);
    const PassReport report = run_pass(mesh, operation, work, options, Progress());
    EXPECT_EQ(report.won, work.size());
    EXPECT_EQ(report.rounds, work.size());
    EXPECT_EQ(mesh.point(VertexId(0U)).x, -3000.0);
  }
}

TEST(Pass, OfNoWorkHasNoRounds) {
  Mesh mesh = test::one_triangle();
  const PassReport report = run_pass(mesh, QueueAtOneVertex(nullptr, 0), {}, PassOptions(), Progress());
  EXPECT_EQ(report.rounds, 0U);
  EXPECT_EQ(report.won, 0U);
}

TEST(Pass, EndsBetweenRoundsWhenCancelled) {
  Mesh mesh = test::one_triangle();
  CancellationToken token;
  const QueueAtOneVertex operation(&token, 10);
  try {
    run_pass(mesh, operation, std::vector<std::uint32_t>(100), PassOptions(), Progress({}, &token));
    FAIL() << "ran to the end";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
  EXPECT_EQ(operation.applied(), 10U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(ClaimChecks, AreSilentOnOperationsThatStayInside) {
  reset_claim_violations();
  flip_all({});
  bisect_all({});
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

TEST(ClaimChecks, CatchAForgottenClaimOfASingleOperation) {
#ifndef QUARRY_CHECK_CLAIMS
  GTEST_SKIP() << "claims are checked in builds with QUARRY_CHECK_CLAIMS (the debug preset) only";
#endif
  reset_claim_violations();
  // One operation alone: it harms nobody, and is caught all the same.
  Mesh mesh = test::mesh_of({{0, 0}, {4, -1}, {8, 0}, {4, 1}}, {{0, 1, 2}, {0, 2, 3}});
  const FlipToDelaunay operation(ConstraintTags::add_to(mesh), true);
  run_pass(mesh, operation, {{VertexId(0U), VertexId(2U)}}, PassOptions(), Progress());
  EXPECT_EQ(operation.applied(), 1U);
  EXPECT_GT(claim_violations().count, 0U);
  EXPECT_NE(claim_violations().first.find("did not claim"), std::string::npos);
  reset_claim_violations();
}

TEST(RankOf, HasNoTiesInARound) {
  std::vector<std::uint32_t> ranks;
  for (std::uint32_t i = 0; i < 20'000; ++i) ranks.push_back(rank_of(i, 3));
  std::sort(ranks.begin(), ranks.end());
  EXPECT_EQ(std::adjacent_find(ranks.begin(), ranks.end()), ranks.end());
}

}  // namespace
}  // namespace quarry
