#include "kernels/local/better_flips.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/quality/element.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

test::SyntheticMesh synthetic(std::uint64_t seed) {
  return test::SyntheticMaker({.columns = 60, .rows = 60, .seed = seed, .flip_share = 0.5}).make();
}

double measure_of(const Mesh& mesh, FaceId f) {
  return lo_measure(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)),
                    mesh.point(mesh.corner(f, 2)));
}

std::size_t count_below(const Mesh& mesh, double limit) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces()) count += measure_of(mesh, f) < limit ? 1 : 0;
  return count;
}

TEST(FlipToBetter, RaisesTheWorstTrianglesAndKeepsConstraints) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SyntheticMesh given = synthetic(seed);
    Mesh& mesh = given.mesh;
    const auto constrained_ends = [&] {
      std::vector<std::pair<VertexId, VertexId>> ends;
      for (const FaceId f : mesh.faces())
        for (int k = 0; k < 3; ++k)
          if (given.tags.constrained(SideId(f, k)))
            ends.emplace_back(mesh.origin(SideId(f, k)), mesh.target(SideId(f, k)));
      std::sort(ends.begin(), ends.end());
      return ends;
    };
    const auto ends = constrained_ends();
    const std::size_t bad = count_below(mesh, 0.4);
    const PassReport report = flip_to_better(mesh, Progress());
    EXPECT_GT(report.won, 100U);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(constrained_ends(), ends);
    EXPECT_LT(count_below(mesh, 0.4), bad);
    EXPECT_EQ(flip_to_better(mesh, Progress()).won, 0U);
  }
}

TEST(FlipToBetter, LeavesSquaresAlone) {
  Mesh mesh = test::triangle_lattice(8, 8, {6.7e6, 6.7e6});
  ConstraintTags::add_to(mesh);
  EXPECT_EQ(flip_to_better(mesh, Progress()).won, 0U);
}

TEST(FlipToBetter, IsTheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] {
    test::SyntheticMesh given = synthetic(9);
    flip_to_better(given.mesh, Progress());
    serial = test::arrays_of(given.mesh);
  });
  for (const int threads : {2, 4, 7}) {
    test::SyntheticMesh given = synthetic(9);
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] { flip_to_better(given.mesh, Progress()); });
    EXPECT_EQ(test::arrays_of(given.mesh), serial) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

}  // namespace
}  // namespace quarry
