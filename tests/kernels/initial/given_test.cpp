#include "kernels/initial/given.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/noded_lines.hpp"

namespace quarry {
namespace {

void expect_refused(const Mesh& mesh, const std::string& words) {
  try {
    (void)adopt_start_mesh(mesh);
    FAIL() << "accepted: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(words), std::string::npos) << error.message();
  }
}

TEST(AdoptStartMesh, TakesADiscOfTriangles) {
  for (const Mesh& given :
       {test::one_triangle(), test::strip(9), test::fan(7, true), test::triangle_lattice(5, 4)}) {
    const Mesh mesh = adopt_start_mesh(given);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(mesh.face_slots(), given.face_slots());
  }
}

TEST(AdoptStartMesh, TurnsOverAMeshThatIsTurnedRight) {
  const Mesh given = test::mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 2, 1}, {0, 3, 2}});
  EXPECT_EQ(validate(adopt_start_mesh(given), GeometryCheck::kPlanarCorners), "");
}

TEST(AdoptStartMesh, LeavesOutPointsWithoutATriangle) {
  EXPECT_EQ(adopt_start_mesh(test::mesh_of({{0, 0}, {9, 9}, {1, 0}, {0, 1}}, {{0, 2, 3}})).vertex_slots(),
            3U);
}

TEST(AdoptStartMesh, RefusesQuadsAndTrianglesOfNoArea) {
  expect_refused(test::mixed(), "quad");
  expect_refused(test::mesh_of({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}}), "no area");
}

TEST(AdoptStartMesh, RefusesAFold) {
  expect_refused(test::mesh_of({{0, 0}, {2, 0}, {1, 2}, {1, 1}}, {{0, 1, 2}, {0, 2, 3}}), "folds over");
}

TEST(AdoptStartMesh, RefusesSeveralParts) {
  expect_refused(test::two_components(), "several parts");
  expect_refused(test::mesh_of({{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}}),
                 "not valid");
}

TEST(AdoptStartMesh, RefusesAHole) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const double turn = std::numbers::pi / 3 * i;
    points.push_back({std::cos(turn), std::sin(turn)});
    points.push_back({2 * std::cos(turn), 2 * std::sin(turn)});
    const std::uint32_t j = (i + 1) % 6;
    faces.push_back({2 * i, 2 * i + 1, 2 * j + 1});
    faces.push_back({2 * i, 2 * j + 1, 2 * j});
  }
  expect_refused(test::mesh_of(points, faces), "hole");
}

TEST(AdoptStartMesh, RefusesAStripThatWindsOverItself) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const double turn = std::numbers::pi / 6 * i;
    points.push_back({std::cos(turn), std::sin(turn)});
    points.push_back({2 * std::cos(turn), 2 * std::sin(turn)});
    if (i == 0) continue;
    faces.push_back({2 * i - 2, 2 * i - 1, 2 * i + 1});
    faces.push_back({2 * i - 2, 2 * i + 1, 2 * i});
  }
  expect_refused(test::mesh_of(points, faces), "overlaps");
}

TEST(AdoptStartMesh, RefusesAMeshThatIsNotFlat) {
  const std::vector<FaceCorners> faces{{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()}};
  expect_refused(build_mesh({0, 1, 0}, {0, 0, 1}, {5, 5, 6}, faces), "not flat");
  EXPECT_TRUE(adopt_start_mesh(build_mesh({0, 1, 0}, {0, 0, 1}, {5, 5, 5}, faces)).planar());
}

TEST(RequireLinesInside, RefusesALineThatReachesTheRim) {
  const Mesh mesh = test::triangle_lattice(4, 4);
  test::NodedLinesBuilder inside;
  inside.piece({0.5, 0.5}, {3.5, 3.5});
  EXPECT_NO_THROW(require_lines_inside(mesh, inside.finish()));
  test::NodedLinesBuilder crossing;
  crossing.piece({0.5, 0.5}, {4.5, 3.5});
  EXPECT_THROW(require_lines_inside(mesh, crossing.finish()), Error);
  test::NodedLinesBuilder touching;
  touching.piece({0.5, 0.5}, {4, 2});
  EXPECT_THROW(require_lines_inside(mesh, touching.finish()), Error);
}

TEST(MakeFourTriangles, CoversTheBoxWithAMargin) {
  const Box2 box{{465'000, 6'691'000}, {465'100, 6'691'020}};
  const Mesh mesh = make_four_triangles(box);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.face_slots(), 4U);
  EXPECT_LT(mesh.box().low.y, box.low.y);
  EXPECT_GT(mesh.box().high.x, box.high.x);
}

}  // namespace
}  // namespace quarry
