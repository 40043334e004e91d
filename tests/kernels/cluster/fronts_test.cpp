#include "kernels/cluster/fronts.hpp"

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/quads.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

TEST(Fronts, RefineAlongConstraintsAndLeaveAValidMesh) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.columns = 40, .rows = 40, .seed = seed, .jitter = 0.2});
    FrontReport report;
    align_fronts(made.mesh, made.lines, {}, report, Progress());
    EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_GT(report.splits.won, 0U);
    EXPECT_LE(report.steps, 5U);
    QuadReport quads;
    const Mesh result = make_quads(std::move(made.mesh), made.lines, {}, quads, Progress());
    EXPECT_EQ(validate(result, GeometryCheck::kPlanarCorners), "");
  }
}

TEST(Fronts, LeaveAMeshWithoutConstraintsAlone) {
  test::SyntheticMesh made = test::make_synthetic({.straight_lines = 0, .crooked_lines = 0});
  FrontReport report;
  align_fronts(made.mesh, made.lines, {}, report, Progress());
  EXPECT_EQ(report.steps, 0U);
}

TEST(Fronts, GiveTheSameMeshOnAnyNumberOfThreads) {
  std::vector<double> x;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      test::SyntheticMesh made = test::make_synthetic({.columns = 60, .rows = 40, .seed = 3});
      const parallel::ParticipationProbe probe;
      FrontReport report;
      align_fronts(made.mesh, made.lines, {}, report, Progress());
      if (threads == 1) {
        x = made.mesh.xs();
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(made.mesh.xs(), x);
    });
  }
}

}  // namespace
}  // namespace quarry
