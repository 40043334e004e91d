#include "kernels/crossfield/position_field.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kernels/crossfield/field_meshes.hpp"

namespace quarry {
namespace {

struct Positions {
  std::vector<FieldLevel> levels;
  std::vector<Vec3> crosses, places;
};

Positions positions_of(const Mesh& mesh, double spacing, std::vector<std::uint8_t> given,
                       const std::vector<Vec3>& directions, const std::vector<Vec3>& places) {
  Positions result{field_levels(finest_level(mesh, std::move(given)), 16), {}, {}};
  result.crosses = cross_field(result.levels, directions, {});
  result.places = position_field(result.levels, result.crosses,
                                 std::vector<double>(mesh.vertex_slots(), spacing), places, {});
  return result;
}

double distance_to_whole(double x) { return std::abs(x - std::round(x)); }

TEST(PositionField, OfASquareOfWholeCellsIsTheirLattice) {
  const Mesh mesh =
      make_sheets(repair_surface(test::terrain(24, 24, [](double, double) { return 0.0; }), {}));
  const double spacing = 1.0 / 14;
  std::vector<Vec3> places;
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.point3(v);
    places.push_back({std::round(p.x / spacing) * spacing, std::round(p.y / spacing) * spacing, 0});
  }
  const Positions found = positions_of(mesh, spacing, test::rim_of(mesh),
                                       std::vector<Vec3>(mesh.vertex_slots(), {1, 0, 0}), places);
  for (const Vec3 p : found.places) {
    EXPECT_LT(distance_to_whole(p.x / spacing), 1e-3);
    EXPECT_LT(distance_to_whole(p.y / spacing), 1e-3);
  }
}

TEST(PositionField, HasPointsNearTheirVerticesInTheirTangentPlanes) {
  const Mesh mesh = test::sphere_mesh(4);
  const double spacing = 0.15;
  const Positions found = positions_of(mesh, spacing, std::vector<std::uint8_t>(mesh.vertex_slots()), {},
                                       std::vector<Vec3>(mesh.vertex_slots()));
  for (std::size_t i = 0; i < found.places.size(); ++i) {
    const Vec3 d = found.places[i] - found.levels[0].points[i];
    EXPECT_LT(length(d), 0.7072 * spacing);
    EXPECT_NEAR(dot(d, found.levels[0].normals[i]), 0, 1e-9);
  }
}

TEST(PositionField, OfNeighboursOnASphereAgreesNearlyEverywhere) {
  const Mesh mesh = test::sphere_mesh(5);
  const double spacing = 0.08;
  const Positions found = positions_of(mesh, spacing, std::vector<std::uint8_t>(mesh.vertex_slots()), {},
                                       std::vector<Vec3>(mesh.vertex_slots()));
  const FieldLevel& level = found.levels[0];
  std::size_t edges = 0, apart = 0;
  for (std::size_t i = 0; i < level.size(); ++i)
    for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e) {
      const Vec3 d = found.places[level.other[e]] - found.places[i];
      const Vec3 along = found.crosses[i];
      ++edges;
      if (distance_to_whole(dot(d, along) / spacing) > 0.25 ||
          distance_to_whole(dot(d, cross(level.normals[i], along)) / spacing) > 0.25)
        ++apart;
    }
  EXPECT_LT(apart, edges / 20);
}

}  // namespace
}  // namespace quarry
