#include "kernels/smooth/square_together.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/compact.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/smooth/square_corners.hpp"
#include "kernels/smooth/star.hpp"
#include "kernels/smooth/wanted_areas.hpp"
#include "tests/kernels/smooth/kept_places.hpp"
#include "tests/kernels/smooth/mean_quality.hpp"
#include "tests/kernels/smooth/quads_with_lines.hpp"
#include "tests/kernels/smooth/same_bits.hpp"

namespace quarry {
namespace {

using test::make_quads;
using test::mean_scaled_jacobian;
using test::QuadsWithLines;

// So many rounds without sweeps between them.
std::uint64_t run_together(QuadsWithLines& quads, const SquareCornersOptions& options, int rounds) {
  const IdVector<FaceId, AreaDemand> demands = area_demands(quads.mesh, options.evenness, nullptr);
  const Slide slide(quads.mesh, ConstraintTags::of(quads.mesh), quads.lines);
  SquareTogether together(quads.mesh, slide, demands, options);
  std::uint64_t moved = 0;
  for (int round = 0; round < rounds; ++round) moved += together.run();
  return moved;
}

std::vector<double> measures(const Mesh& mesh) {
  std::vector<double> result;
  for (const FaceId f : mesh.faces()) result.push_back(Star::measure_of(mesh, f));
  return result;
}

class SquareTogetherOn : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SquareTogetherOn, RandomQuadsLowersNoFaceThatIsBelowTheFloorNorAnyOtherBelowIt) {
  QuadsWithLines quads = make_quads({.seed = GetParam(), .slivers = GetParam() % 3 == 0 ? 0.02 : 0});
  for (const double evenness : {0.0, 0.3}) {
    const SquareCornersOptions options{.evenness = evenness};
    const double floor = options.floor * options.floor;
    const std::vector<double> before = measures(quads.mesh);
    EXPECT_GT(run_together(quads, options, 1), 0U);
    EXPECT_EQ(validate(quads.mesh, GeometryCheck::kPlanarCorners), "");
    const std::vector<double> after = measures(quads.mesh);
    for (std::size_t f = 0; f < before.size(); ++f)
      EXPECT_GE(after[f], std::min(before[f], floor) * (1 - 1e-9)) << "face " << f;
  }
}

TEST_P(SquareTogetherOn, RandomQuadsKeepsTheBitsOfFixedVerticesAndSlidersOnTheirPieces) {
  QuadsWithLines quads = make_quads({.seed = GetParam()});
  test::expect_fixed_and_sliders_kept(quads, [&] { run_together(quads, {}, 2); });
}

TEST_P(SquareTogetherOn, RandomQuadsLiftsTheMean) {
  QuadsWithLines quads = make_quads({.seed = GetParam(), .jitter = 0.2, .flip_share = 0.05});
  const double mean = mean_scaled_jacobian(quads.mesh);
  run_together(quads, {}, 1);
  EXPECT_GT(mean_scaled_jacobian(quads.mesh), mean);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SquareTogetherOn, testing::Range<std::uint64_t>(1, 13));

// A square lattice whose inside is bent by long waves; the rim is as it was.
QuadsWithLines make_wave() {
  QuadsWithLines quads = make_quads({.columns = 40,
                                     .rows = 40,
                                     .jitter = 0,
                                     .flip_share = 0,
                                     .straight_lines = 0,
                                     .crooked_lines = 0,
                                     .origin = {0, 0}});
  compact(quads.mesh, EntityOrder::kHilbert);
  const double side = quads.mesh.box().high.x;
  for (const VertexId v : quads.mesh.vertices()) {
    const Vec2 p = quads.mesh.point(v);
    const double wave =
        0.02 * side * std::sin(4 * std::numbers::pi * p.x / side) * std::sin(std::numbers::pi * p.y / side);
    if (!quads.mesh.on_boundary(v)) quads.mesh.set_point(v, {p.x, p.y + wave});
  }
  return quads;
}

double mean_squared_cosine(const Mesh& mesh) {
  double sum = 0;
  for (const FaceId f : mesh.faces()) {
    const double sine = scaled_jacobian(mesh, f);
    sum += 1 - sine * sine;
  }
  return sum / static_cast<double>(mesh.face_slots());
}

TEST(SquareTogether, RemovesLongWavesInAFewRoundsThatSweepsHardlyTouch) {
  QuadsWithLines together = make_wave();
  QuadsWithLines swept = make_wave();
  const double before = mean_squared_cosine(together.mesh);
  run_together(together, {}, 4);
  square_corners(swept.mesh, swept.lines, {.sweeps = 12}, Progress());
  EXPECT_LT(mean_squared_cosine(together.mesh), 0.2 * before);
  EXPECT_GT(mean_squared_cosine(swept.mesh), 0.5 * before);
}

TEST(SquareTogether, LeavesARegularMeshAsItIs) {
  QuadsWithLines quads = make_quads({.jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
  const std::vector<double> x = quads.mesh.xs();
  EXPECT_EQ(run_together(quads, {}, 2), 0U);
  EXPECT_EQ(quads.mesh.xs(), x);
}

TEST(SquareTogether, GivesTheSameBitsOnAnyNumberOfThreads) {
  test::expect_same_bits_on_threads([](QuadsWithLines& quads) { run_together(quads, {.evenness = 0.3}, 3); });
}

TEST(SquareTogether, TurnsTheCornersOfTrianglesTowardsSixtyDegrees) {
  test::SyntheticMesh made = test::make_synthetic({.seed = 5, .jitter = 0.2, .flip_share = 0});
  const double mean = mean_scaled_jacobian(made.mesh);
  const IdVector<FaceId, AreaDemand> demands = area_demands(made.mesh, 0.3, nullptr);
  const Slide slide(made.mesh, made.tags, made.lines);
  const SquareCornersOptions options{.evenness = 0.3};
  SquareTogether(made.mesh, slide, demands, options).run();
  EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(mean_scaled_jacobian(made.mesh), mean);
}

}  // namespace
}  // namespace quarry
