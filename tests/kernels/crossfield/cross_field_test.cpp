#include "kernels/crossfield/cross_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "kernels/crossfield/singularities.hpp"
#include "tests/kernels/crossfield/field_meshes.hpp"

namespace quarry {
namespace {

constexpr std::size_t kFewest = 16;

struct Crosses {
  std::vector<FieldLevel> levels;
  std::vector<Vec3> directions;
};

Crosses crosses_of(const Mesh& mesh, std::vector<std::uint8_t> given, const std::vector<Vec3>& directions,
                   const CrossFieldOptions& options = {}, const std::vector<Vec3>& axes = {}) {
  Crosses result{field_levels(finest_level(mesh, std::move(given), axes), kFewest), {}};
  result.directions = cross_field(result.levels, directions, options);
  return result;
}

Crosses free_crosses(const Mesh& mesh, const CrossFieldOptions& options = {},
                     const std::vector<Vec3>& axes = {}) {
  return crosses_of(mesh, std::vector<std::uint8_t>(mesh.vertex_slots()), {}, options, axes);
}

int sum_of_turns(const Mesh& mesh, const Crosses& crosses) {
  int sum = 0;
  for (const Singularity& s : find_singularities(mesh, crosses.levels[0], crosses.directions))
    sum += s.quarter_turns;
  return sum;
}

// Of crosses of length 1.
double energy(const Crosses& crosses) {
  const FieldLevel& level = crosses.levels[0];
  double sum = 0;
  for (std::size_t i = 0; i < level.size(); ++i)
    for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e) {
      const std::uint32_t j = level.other[e];
      const Vec2 theirs = complex_product(level.turn[e], cross_number(level, j, crosses.directions[j]));
      sum += squared_length(theirs - cross_number(level, i, crosses.directions[i]));
    }
  return sum;
}

// Along the unit circle.
std::vector<Vec3> around_the_origin(const Mesh& mesh) {
  std::vector<Vec3> directions;
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.point3(v);
    directions.push_back(length(p) > 0 ? (1 / length(p)) * Vec3{-p.y, p.x, 0} : Vec3{1, 0, 0});
  }
  return directions;
}

TEST(CrossField, OfASphereTurnsEightQuartersInAll) {
  for (const int rounds : {3, 4, 5}) {
    const Mesh mesh = test::sphere_mesh(rounds);
    const Crosses crosses = free_crosses(mesh);
    EXPECT_EQ(sum_of_turns(mesh, crosses), 8);
    EXPECT_EQ(find_singularities(mesh, crosses.levels[0], crosses.directions).size(), 8U);
  }
}

TEST(CrossField, OfADiskThatFollowsItsRimHasFourSingularities) {
  const Mesh mesh = test::disk_mesh(20);
  const Crosses crosses = crosses_of(mesh, test::rim_of(mesh), around_the_origin(mesh));
  const auto found = find_singularities(mesh, crosses.levels[0], crosses.directions);
  ASSERT_EQ(found.size(), 4U);
  for (const Singularity& s : found) EXPECT_EQ(s.quarter_turns, 1);
}

TEST(CrossField, KeepsWhatIsGivenAndFillsAPlaneWithIt) {
  const Mesh mesh = test::disk_mesh(12);
  const Vec3 along{std::cos(0.3), std::sin(0.3), 0};
  const Crosses crosses = crosses_of(mesh, test::rim_of(mesh), std::vector<Vec3>(mesh.vertex_slots(), along));
  for (const Vec3 d : crosses.directions) {
    const double cosine = std::abs(dot(d, along));
    EXPECT_NEAR(std::min(cosine, 1 - cosine), 0, 1e-9);
  }
}

TEST(CrossField, IsUnitAndTangent) {
  const Mesh mesh = test::sphere_mesh(4);
  const Crosses crosses = free_crosses(mesh);
  for (std::size_t i = 0; i < crosses.directions.size(); ++i) {
    EXPECT_NEAR(length(crosses.directions[i]), 1, 1e-12);
    EXPECT_NEAR(dot(crosses.directions[i], crosses.levels[0].normals[i]), 0, 1e-12);
  }
}

TEST(CrossField, DoesNotDependOnTheAxesThatAnglesAreCountedFrom) {
  const Mesh mesh = test::disk_mesh(16);
  std::vector<Vec3> axes;
  for (std::size_t i = 0; i < mesh.vertex_slots(); ++i) {
    const double angle = 7 * uniform01(1, i);
    axes.push_back({std::cos(angle), std::sin(angle), 0});
  }
  const Crosses one = crosses_of(mesh, test::rim_of(mesh), around_the_origin(mesh));
  const Crosses other = crosses_of(mesh, test::rim_of(mesh), around_the_origin(mesh), {}, axes);
  for (std::size_t i = 0; i < one.directions.size(); ++i) {
    const Vec2 a = cross_number(one.levels[0], i, one.directions[i]);
    const Vec2 b = cross_number(one.levels[0], i, other.directions[i]);
    EXPECT_NEAR(length(a - b), 0, 1e-6) << i;
  }
}

TEST(CrossField, FromCoarseToFineIsNearlyAsSmoothAsTheDirectSolution) {
  const Mesh mesh = test::sphere_mesh(5);
  const double direct = energy(free_crosses(mesh, {.coarsest = std::numeric_limits<std::size_t>::max()}));
  const double by_levels = energy(free_crosses(mesh));
  EXPECT_LT(by_levels, 1.25 * direct);
}

// One fades against the other where both are solved for as one.
TEST(CrossField, OfAPartWithNothingGivenBesideOneWithARimIsSmooth) {
  TriangleSurface surface = test::sphere(3);
  const TriangleSurface flat = test::terrain(8, 8, [](double, double) { return 3.0; });
  const auto offset = static_cast<std::uint32_t>(surface.points.size());
  surface.points.insert(surface.points.end(), flat.points.begin(), flat.points.end());
  for (const auto& [a, b, c] : flat.triangles)
    surface.triangles.push_back({a + offset, b + offset, c + offset});
  surface.groups.resize(surface.triangles.size());
  const Mesh mesh = make_sheets(repair_surface(std::move(surface), {}));
  const Crosses crosses =
      crosses_of(mesh, test::rim_of(mesh), std::vector<Vec3>(mesh.vertex_slots(), {1, 0, 0}));
  EXPECT_EQ(find_singularities(mesh, crosses.levels[0], crosses.directions).size(), 8U);
}

TEST(FieldLevels, KeepTheLaplacianOfTheFinest) {
  const Mesh mesh = test::sphere_mesh(3);
  const std::vector<FieldLevel> levels =
      field_levels(finest_level(mesh, std::vector<std::uint8_t>(mesh.vertex_slots())), kFewest);
  ASSERT_GT(levels.size(), 3U);
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    const FieldLevel& fine = levels[l];
    const FieldLevel& coarse = levels[l + 1];
    EXPECT_LT(coarse.size(), fine.size());
    std::vector<Vec2> z(coarse.size()), below(fine.size());
    for (std::size_t i = 0; i < coarse.size(); ++i)
      z[i] = {uniform01(3, 2 * i) - 0.5, uniform01(3, 2 * i + 1) - 0.5};
    for (std::size_t i = 0; i < fine.size(); ++i)
      below[i] = complex_product(fine.from_parent[i], z[fine.parent[i]]);
    const auto form = [](const FieldLevel& level, const std::vector<Vec2>& x) {
      double sum = 0;
      for (std::size_t i = 0; i < level.size(); ++i) {
        sum += level.diagonal[i] * squared_length(x[i]);
        for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
          sum -= dot(x[i], complex_product(level.turn[e], x[level.other[e]]));
      }
      return sum;
    };
    EXPECT_NEAR(form(coarse, z), form(fine, below), 1e-9 * form(fine, below));
  }
}

TEST(FieldLevels, OfClassesHaveNoTwoThatAreJoined) {
  const Mesh mesh = test::disk_mesh(10);
  for (const FieldLevel& level : field_levels(finest_level(mesh, test::rim_of(mesh)), kFewest)) {
    std::vector<std::size_t> class_of(level.size(), level.size());
    for (std::size_t c = 0; c < level.classes.size(); ++c)
      for (const std::uint32_t i : level.classes[c]) class_of[i] = c;
    for (std::size_t i = 0; i < level.size(); ++i) {
      EXPECT_EQ(level.given[i] != 0, class_of[i] == level.size());
      for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
        if (level.given[i] == 0) {
          EXPECT_NE(class_of[i], class_of[level.other[e]]);
        }
    }
  }
}

}  // namespace
}  // namespace quarry
