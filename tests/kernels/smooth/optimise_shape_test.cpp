#include "kernels/smooth/optimise_shape.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/quality/face.hpp"
#include "tests/kernels/smooth/kept_places.hpp"
#include "tests/kernels/smooth/quads_with_lines.hpp"
#include "tests/kernels/smooth/same_bits.hpp"

namespace quarry {
namespace {

using test::make_quads;
using test::QuadsWithLines;

struct Jacobians {
  double smallest = 1, mean = 0;

  explicit Jacobians(const Mesh& mesh) {
    for (const FaceId f : mesh.faces()) {
      const double value = scaled_jacobian(mesh, f);
      smallest = std::min(smallest, value);
      mean += value / static_cast<double>(mesh.face_slots());
    }
  }
};

class ShapeOf : public testing::TestWithParam<std::uint64_t> {
 protected:
  ShapeOf() : quads_(make_quads({.seed = GetParam(), .slivers = GetParam() % 3 == 0 ? 0.02 : 0})) {}
  QuadsWithLines quads_;
};

TEST_P(ShapeOf, QuadsImprovesInTheMeanAndFallsBelowTheFloorNowhere) {
  const Jacobians before(quads_.mesh);
  const ShapeOptions options;
  optimise_shape(quads_.mesh, quads_.lines, options, Progress());
  const Jacobians after(quads_.mesh);
  EXPECT_EQ(validate(quads_.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(after.mean, before.mean);
  // A hair for the rounding of two ways to the same number.
  EXPECT_GE(after.smallest, std::min(before.smallest, options.floor) - 1e-12);
}

TEST_P(ShapeOf, QuadsKeepsTheBitsOfFrozenVerticesAndSlidersOnTheirPieces) {
  test::expect_fixed_and_sliders_kept(quads_,
                                      [this] { optimise_shape(quads_.mesh, quads_.lines, {}, Progress()); });
}

TEST_P(ShapeOf, TrianglesImprovesInTheMean) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  const Jacobians before(made.mesh);
  optimise_shape(made.mesh, made.lines, {}, Progress());
  EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(Jacobians(made.mesh).mean, before.mean);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ShapeOf, testing::Range<std::uint64_t>(1, 13));

TEST(OptimiseShape, GivesTheSameBitsOnAnyNumberOfThreads) {
  test::expect_same_bits_on_threads([](QuadsWithLines& quads) {
    const UniformSize size(1);
    optimise_shape(quads.mesh, quads.lines, {.size = &size}, Progress());
    optimise_shape(quads.mesh, quads.lines, {}, Progress());
  });
}

TEST(OptimiseShape, LooksOnceAtARegularMesh) {
  QuadsWithLines quads = make_quads({.jitter = 0, .flip_share = 0, .straight_lines = 0, .crooked_lines = 0});
  EXPECT_EQ(optimise_shape(quads.mesh, quads.lines, {}, Progress()).visited, 0U);
}

// A block of quads between straight sides; inner vertices are free, those of the rim fixed. place(i, j): of
// the lattice point in the unit square, for i and j in [0, 1].
template <class Place>
Mesh fixed_block(std::uint32_t columns, std::uint32_t rows, const Place& place) {
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return VertexId(j * (columns + 1) + i); };
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const Vec2 p = place(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      x.push_back(p.x);
      y.push_back(p.y);
      if (i > 0 && j > 0) faces.push_back({id(i - 1, j - 1), id(i, j - 1), id(i, j), id(i - 1, j)});
    }
  Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  return mesh;
}

TEST(OptimiseShape, KeepsTheRightAnglesOfABlockWhoseFixedRimAsksForRectangles) {
  // Slanted inside: only the rim knows the right angles.
  Mesh mesh = fixed_block(12, 12, [](double s, double t) {
    return Vec2{36 * (s + 0.4 * s * (1 - s) * t * (1 - t)), 12 * (t + 0.5 * s * (1 - s) * t * (1 - t))};
  });
  optimise_shape(mesh, {}, {.sweeps = 100, .tolerance = 1e-4}, Progress());
  EXPECT_GT(Jacobians(mesh).smallest, 0.999);
}

TEST(OptimiseShape, EvensOutTheAreasWhereOneSizeIsWanted) {
  // Inside the rim the lattice is drawn to one side.
  Mesh mesh = fixed_block(24, 24, [](double s, double t) {
    const bool inside = s > 0 && s < 1 && t > 0 && t < 1;
    return Vec2{24 * (inside ? std::pow(s, 1.6) : s), 24 * t};
  });
  const UniformSize size(1);
  optimise_shape(mesh, {}, {.sweeps = 100, .size = &size}, Progress());
  std::vector<double> areas;
  for (const FaceId f : mesh.faces())
    areas.push_back(measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); }));
  std::sort(areas.begin(), areas.end());
  EXPECT_LT(areas[areas.size() * 99 / 100] / areas[areas.size() / 100], 2);
}

TEST(OptimiseShape, TurnsBackAFaceThatIsTurnedOver) {
  Mesh mesh = fixed_block(6, 6, [](double s, double t) {
    const bool middle = s == 0.5 && t == 0.5;
    return Vec2{6 * (middle ? 0.7 : s), 6 * (middle ? 0.6 : t)};
  });
  EXPECT_LT(Jacobians(mesh).smallest, 0);
  optimise_shape(mesh, {}, {.sweeps = 20}, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GT(Jacobians(mesh).smallest, 0.9);
}

}  // namespace
}  // namespace quarry
