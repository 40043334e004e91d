#include "engine/mesh/build.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

void expect_refused(const std::vector<Vec2>& points, const std::vector<std::vector<std::uint32_t>>& faces,
                    const std::string& words) {
  try {
    (void)test::mesh_of(points, faces);
    FAIL() << "accepted: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(words), std::string::npos) << error.message();
  }
}

TEST(BuildMesh, RefusesThreeFacesAtAnEdgeAndNamesThePlace) {
  expect_refused({{10, 20}, {11, 20}, {10, 21}, {10, 19}, {10.5, 22}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                 "has three faces or more");
  expect_refused({{10, 20}, {11, 20}, {10, 21}, {10, 19}, {10.5, 22}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                 "20");
}

TEST(BuildMesh, RefusesFacesThatTurnTheSameWayAlongAnEdge) {
  expect_refused({{0, 0}, {1, 0}, {0, 1}, {0, -1}}, {{0, 1, 2}, {0, 1, 3}}, "turned the same way");
}

TEST(BuildSheets, EndsThreeSheetsWhereTheyMeet) {
  // Three quads around an edge, and a fourth face beside one of them.
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)},
                                          {VertexId(1U), VertexId(0U), VertexId(4U), VertexId(5U)},
                                          {VertexId(0U), VertexId(1U), VertexId(6U), VertexId(7U)},
                                          {VertexId(1U), VertexId(5U), VertexId(8U), VertexId()}};
  const Mesh mesh = build_sheets({0, 1, 1, 0, 0, 1, 1, 0, 2}, {0, 0, 1, 1, -1, -1, 0, 0, 0},
                                 {0, 0, 0, 0, 0, 0, 1, 1, 0}, faces);
  EXPECT_EQ(mesh.vertex_slots(), 13U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
  const auto pinch = mesh.find_tag<VertexId, std::uint8_t>(kPinchTag);
  std::size_t pinched = 0;
  for (const VertexId v : mesh.vertices()) {
    pinched += pinch[v];
    EXPECT_EQ(pinch[v] != 0, v.value() < 2 || v.value() > 8);
    if (v.value() > 8) {
      EXPECT_EQ(mesh.point3(v).y, 0);
    }
  }
  EXPECT_EQ(pinched, 6U);
  EXPECT_EQ(mesh.neighbour(SideId(FaceId(1U), 3)), SideId(FaceId(3U), 0));
}

TEST(BuildSheets, CutsAOneSidedBandOpenOnce) {
  // Five quads in a ring, the last one turned over.
  std::vector<double> x, y, z;
  for (int i = 0; i < 5; ++i)
    for (const double side : {-1.0, 1.0}) {
      x.push_back(std::cos(1.256 * i) * (3 + 0.5 * side));
      y.push_back(std::sin(1.256 * i) * (3 + 0.5 * side));
      z.push_back(side * i);
    }
  const auto corner = [](std::uint32_t i, std::uint32_t k) { return VertexId(2 * i + k); };
  std::vector<FaceCorners> faces;
  for (std::uint32_t i = 0; i < 4; ++i)
    faces.push_back({corner(i, 0), corner(i, 1), corner(i + 1, 1), corner(i + 1, 0)});
  faces.push_back({corner(4, 0), corner(4, 1), corner(0, 0), corner(0, 1)});
  const Mesh mesh = build_sheets(x, y, z, faces);
  EXPECT_EQ(mesh.vertex_slots(), 12U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
}

TEST(BuildSheets, LeavesASurfaceWithoutThemAsItIs) {
  const Mesh mesh =
      build_sheets({0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 1},
                   std::vector<FaceCorners>{{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()},
                                            {VertexId(1U), VertexId(3U), VertexId(2U), VertexId()}});
  EXPECT_EQ(mesh.vertex_slots(), 4U);
  EXPECT_FALSE((mesh.find_tag<VertexId, std::uint8_t>(kPinchTag).valid()));
}

TEST(BuildMesh, RefusesAFaceThatRepeatsACorner) {
  expect_refused({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 1}}, "face 0 has point 1 twice");
  expect_refused({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {0, 1, 2, 0}}, "face 1 has point 0 twice");
}

TEST(BuildMesh, RefusesACornerThatIsNoPoint) {
  expect_refused({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}}, "face 0 names a point that does not exist");
  expect_refused({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}}, "face 0 names a point that does not exist");
}

TEST(BuildMesh, KeepsTheOrderOfPointsAndFaces) {
  const Mesh mesh = test::mixed();
  EXPECT_EQ(mesh.point(VertexId(3U)), (Vec2{2, 1}));
  EXPECT_EQ(mesh.corner(FaceId(2U), 0), VertexId(7U));
  EXPECT_EQ(mesh.corner_count(FaceId(2U)), 3);
  EXPECT_EQ(mesh.corner_count(FaceId(4U)), 4);
}

TEST(BuildMesh, DeletesPointsWithoutAFace) {
  const Mesh mesh = test::mesh_of({{0, 0}, {9, 9}, {1, 0}, {0, 1}}, {{0, 2, 3}});
  EXPECT_FALSE(mesh.alive(VertexId(1U)));
  EXPECT_EQ(mesh.count_alive_vertices(), 3U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(BuildMesh, MakesEveryMeshOfTheZooValidAndBalanced) {
  for (const test::ZooMesh& zoo : test::mesh_zoo()) {
    SCOPED_TRACE(zoo.name);
    EXPECT_EQ(validate(zoo.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(test::charge_of(zoo.mesh), 4 * zoo.euler);
  }
}

TEST(FindSide, FindsEachSideOfEachFaceAndNothingElse) {
  for (const test::ZooMesh& zoo : test::mesh_zoo()) {
    SCOPED_TRACE(zoo.name);
    const Mesh& mesh = zoo.mesh;
    for (const FaceId f : mesh.faces())
      for (int k = 0; k < mesh.corner_count(f); ++k)
        EXPECT_EQ(mesh.find_side(mesh.origin(SideId(f, k)), mesh.target(SideId(f, k))), SideId(f, k));
    for (const VertexId v : mesh.vertices()) EXPECT_FALSE(mesh.find_side(v, v).valid());
  }
  EXPECT_FALSE(test::two_triangles().find_side(VertexId(1U), VertexId(3U)).valid());
  // A boundary edge has a side in one direction only.
  EXPECT_FALSE(test::one_triangle().find_side(VertexId(1U), VertexId(0U)).valid());
}

TEST(SideOf, StartsATurnThatSeesTheWholeStar) {
  for (const test::ZooMesh& zoo : test::mesh_zoo()) {
    SCOPED_TRACE(zoo.name);
    std::vector<int> corners(zoo.mesh.vertex_slots(), 0);
    for (const FaceId f : zoo.mesh.faces())
      for (int k = 0; k < zoo.mesh.corner_count(f); ++k) ++corners[zoo.mesh.corner(f, k).value()];
    for (const VertexId v : zoo.mesh.vertices()) {
      int seen = 0;
      for_each_side_around(zoo.mesh, v, [&](SideId s) {
        EXPECT_EQ(zoo.mesh.origin(s), v);
        ++seen;
      });
      EXPECT_EQ(seen, corners[v.value()]);
    }
  }
}

TEST(OnBoundary, HoldsOnTheRimAndNotInside) {
  const Mesh closed = test::fan(6, true);
  EXPECT_FALSE(closed.on_boundary(VertexId(0U)));
  EXPECT_TRUE(closed.on_boundary(VertexId(1U)));
  EXPECT_TRUE(test::fan(6, false).on_boundary(VertexId(0U)));
  const Mesh ring = test::annulus(8);
  for (const VertexId v : ring.vertices()) EXPECT_TRUE(ring.on_boundary(v));
}

}  // namespace
}  // namespace quarry
