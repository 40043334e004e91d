#include "kernels/crossfield/spacing_field.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kernels/crossfield/field_meshes.hpp"

namespace quarry {
namespace {

constexpr SpacingFieldOptions kFree{.reach = 1e3, .most = 10, .steps = 1000, .accuracy = 1e-6};

std::vector<double> spacing_of(const Mesh& mesh, const std::vector<Vec3>& directions,
                               const SpacingFieldOptions& options) {
  const FieldLevel level = finest_level(mesh, std::vector<std::uint8_t>(mesh.vertex_slots(), 1));
  return spacing_field(mesh, spacing_sources(mesh, level, directions), options);
}

Mesh flat_square() {
  return make_sheets(repair_surface(test::terrain(24, 24, [](double, double) { return 0.0; }), {}));
}

TEST(SpacingField, IsEvenWhereCrossesAreParallel) {
  const Mesh mesh = flat_square();
  for (const double s : spacing_of(mesh, std::vector<Vec3>(mesh.vertex_slots(), {0.6, 0.8, 0}), kFree))
    EXPECT_NEAR(s, 0, 1e-12);
}

// Between radius 1 and 2, with crosses that follow the circles: as many cells on each circle. Triangles with
// a right angle, which are taken for equilateral ones, make a sixth less of it.
TEST(SpacingField, GrowsWithTheRadiusOfCirclesThatCrossesFollow) {
  Mesh mesh = flat_square();
  std::vector<Vec3> directions;
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = std::log(2) * mesh.point3(v);
    const Vec3 out{std::cos(p.y), std::sin(p.y), 0};
    mesh.set_point3(v, std::exp(p.x) * out);
    directions.push_back(out);
  }
  const std::vector<double> logarithms = spacing_of(mesh, directions, kFree);
  double inner = 0, outer = 0;
  for (const VertexId v : mesh.vertices()) {
    const double radius = length(mesh.point3(v));
    if (radius < 1.001) inner += logarithms[v.value()] / 25;
    if (radius > 1.999) outer += logarithms[v.value()] / 25;
  }
  EXPECT_NEAR(outer - inner, std::log(2), 0.2 * std::log(2));
  for (const double s : spacing_of(mesh, directions, {.most = 0.1})) EXPECT_LE(std::abs(s), 0.1);
}

}  // namespace
}  // namespace quarry
