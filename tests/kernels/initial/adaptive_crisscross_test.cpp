#include "kernels/initial/adaptive_crisscross.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/field/graded_size.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

const Box2 kBox{{465'000, 6'691'000}, {465'100, 6'691'080}};

GradedSize two_sources() {
  return GradedSize({{{{465'020, 6'691'020}, {465'060, 6'691'050}}, 0.5},
                     {{{465'090, 6'691'010}, {465'090, 6'691'010}}, 0.2}},
                    {.largest = 10, .gradation = 0.25});
}

constexpr AdaptiveCrisscrossOptions kTurned{.coarsest = 10, .finest = 0.01, .angle_degrees = 20};

// Ascending squared lengths of the sides.
std::array<double, 3> sides_of(const Mesh& mesh, FaceId f) {
  std::array<double, 3> sides{};
  for (int k = 0; k < 3; ++k)
    sides[static_cast<std::size_t>(k)] =
        squared_length(mesh.point(mesh.corner(f, (k + 1) % 3)) - mesh.point(mesh.corner(f, k)));
  std::sort(sides.begin(), sides.end());
  return sides;
}

Vec2 middle_of(const Mesh& mesh, FaceId f) {
  return (1.0 / 3) *
         (mesh.point(mesh.corner(f, 0)) + mesh.point(mesh.corner(f, 1)) + mesh.point(mesh.corner(f, 2)));
}

TEST(AdaptiveCrisscross, ConformsAndHasRightIsoscelesTrianglesOnly) {
  const Mesh mesh = make_adaptive_crisscross(kBox, two_sources(), kTurned, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.count_alive_faces(), mesh.face_slots());
  // The lattice is stretched to a whole number of cells: by up to half a cell in eight.
  for (const FaceId f : mesh.faces()) {
    const auto [leg, other_leg, base] = sides_of(mesh, f);
    EXPECT_NEAR(other_leg, leg, 0.2 * leg);
    EXPECT_NEAR(base, leg + other_leg, 0.2 * base);
  }
}

TEST(AdaptiveCrisscross, HasExactlySquareAnglesWhereTheBoxIsAWholeNumberOfCells) {
  const Mesh mesh =
      make_adaptive_crisscross(kBox, two_sources(), {.coarsest = 10, .finest = 0.01}, Progress());
  for (const FaceId f : mesh.faces()) {
    const auto [leg, other_leg, base] = sides_of(mesh, f);
    EXPECT_NEAR(other_leg, leg, 1e-6 * leg);
    EXPECT_NEAR(base, 2 * leg, 1e-6 * leg);
  }
}

TEST(AdaptiveCrisscross, FollowsTheFieldWithinAFactorOfTwo) {
  const GradedSize field = two_sources();
  const Mesh mesh = make_adaptive_crisscross(kBox, field, {.coarsest = 10, .finest = 0.01}, Progress());
  for (const FaceId f : mesh.faces()) {
    const Vec2 p = middle_of(mesh, f);
    if (!kBox.contains(p)) continue;
    const double leg = std::sqrt(sides_of(mesh, f)[0]);
    EXPECT_LT(leg, 2 * field.at(p));
    EXPECT_GT(leg, 0.5 * field.at(p));
  }
}

TEST(AdaptiveCrisscross, IsThePlainLatticeWhereItIsFineEnough) {
  const Mesh mesh = make_adaptive_crisscross(kBox, UniformSize(100), {.coarsest = 10}, Progress());
  EXPECT_EQ(mesh.face_slots(), 2U * (10 + 2) * (8 + 2));
}

TEST(AdaptiveCrisscross, IsTheSameOnAnyNumberOfThreads) {
  const GradedSize field = two_sources();
  std::vector<std::uint64_t> serial;
  parallel::with_threads(
      1, [&] { serial = test::arrays_of(make_adaptive_crisscross(kBox, field, kTurned, Progress())); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      EXPECT_EQ(test::arrays_of(make_adaptive_crisscross(kBox, field, kTurned, Progress())), serial)
          << threads << " threads";
    });
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST(AdaptiveCrisscross, StopsAtTheFinestLeg) {
  const Mesh mesh =
      make_adaptive_crisscross(kBox, UniformSize(1e-9), {.coarsest = 10, .finest = 2}, Progress());
  for (const FaceId f : mesh.faces()) EXPECT_GT(sides_of(mesh, f)[0], 1);
}

TEST(AdaptiveCrisscross, RefusesASizeThatIsNotPositive) {
  EXPECT_THROW((void)make_adaptive_crisscross(kBox, UniformSize(0), kTurned, Progress()), Error);
}

}  // namespace
}  // namespace quarry
