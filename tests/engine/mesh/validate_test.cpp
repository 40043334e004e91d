#include "engine/mesh/validate.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

// Each test breaks one relation of a valid mesh.
Mesh victim() { return test::triangle_lattice(3, 3); }

// A side with a face across.
SideId interior_side(const Mesh& mesh) {
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (mesh.neighbour(SideId(f, k)).valid()) return SideId(f, k);
  return {};
}

void expect_names(const Mesh& mesh, const std::string& words, GeometryCheck geometry = GeometryCheck::kNone) {
  const std::string found = validate(mesh, geometry);
  EXPECT_NE(found.find(words), std::string::npos) << "said: " << found;
}

TEST(Validate, IsSilentOnAValidMesh) { EXPECT_EQ(validate(victim(), GeometryCheck::kPlanarCorners), ""); }

TEST(Validate, NamesACornerThatIsNoVertex) {
  Mesh mesh = victim();
  mesh.set_corner(SideId(FaceId(4U), 1), VertexId(1000U));
  expect_names(mesh, "face 4: corner 1 is no vertex");
}

TEST(Validate, NamesACornerThatIsDeleted) {
  Mesh mesh = victim();
  mesh.delete_vertex(mesh.corner(FaceId(0U), 2));
  expect_names(mesh, "face 0: corner 2 is deleted");
}

TEST(Validate, NamesARepeatedCorner) {
  Mesh mesh = victim();
  mesh.set_corner(SideId(FaceId(0U), 2), mesh.corner(FaceId(0U), 0));
  expect_names(mesh, "face 0: corners 0 and 2 are the same");
}

TEST(Validate, NamesANeighbourThatIsNoSide) {
  Mesh mesh = victim();
  mesh.set_neighbour(SideId(FaceId(0U), 0), SideId(FaceId(999U), 0));
  expect_names(mesh, "neighbour of side 0.0 is no side");
  Mesh fourth = victim();
  fourth.set_neighbour(SideId(FaceId(0U), 0), SideId(FaceId(5U), 3));
  expect_names(fourth, "neighbour of side 0.0 is no side");
}

TEST(Validate, NamesANeighbourInADeletedFace) {
  Mesh mesh = victim();
  const SideId s = interior_side(mesh);
  mesh.delete_face(mesh.neighbour(s).face());
  expect_names(mesh, "is no side of a face");
}

TEST(Validate, NamesNeighboursThatAreNotMutual) {
  Mesh mesh = victim();
  mesh.set_neighbour(mesh.neighbour(interior_side(mesh)), SideId());
  expect_names(mesh, "whose neighbour is another side");
}

TEST(Validate, NamesNeighboursOfDifferentEdges) {
  Mesh mesh = victim();
  const SideId s = interior_side(mesh);
  const SideId t = mesh.neighbour(s);
  const SideId wrong(FaceId(mesh.face_slots() - 1), 0);
  mesh.set_neighbour(t, SideId());
  mesh.set_neighbour(s, wrong);
  mesh.set_neighbour(wrong, s);
  expect_names(mesh, "do not join the same two vertices");
}

TEST(Validate, NamesACornerThatDoesNotTurnLeft) {
  Mesh mesh = victim();
  const VertexId inner(5U);
  mesh.set_point(inner, mesh.point(VertexId(10U)));
  expect_names(mesh, "does not turn left", GeometryCheck::kPlanarCorners);
  EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
}

TEST(Validate, NamesAFaceOfNoArea) {
  const Mesh mesh = test::mesh_of({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}});
  expect_names(mesh, "does not turn left", GeometryCheck::kPlanarCorners);
}

TEST(Validate, NamesAQuadWithAReflexCorner) {
  const Mesh mesh = test::mesh_of({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, {{0, 1, 2, 3}});
  expect_names(mesh, "does not turn left", GeometryCheck::kPlanarCorners);
}

TEST(Validate, NamesASideThatDoesNotStartAtItsVertex) {
  Mesh mesh = victim();
  mesh.set_side_of(VertexId(5U), mesh.next(mesh.side_of(VertexId(5U))));
  expect_names(mesh, "does not start there");
}

TEST(Validate, NamesASideThatIsNotTheMostClockwiseOfTheBoundary) {
  Mesh mesh = test::fan(4, false);
  mesh.set_side_of(VertexId(0U), mesh.turn_left(mesh.side_of(VertexId(0U))));
  expect_names(mesh, "side_of is not the most clockwise");
}

TEST(Validate, NamesAVertexWithTwoFans) {
  const Mesh mesh = test::mesh_of({{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  expect_names(mesh, "two fans");
}

TEST(Validate, NamesAnEdgeWithADeletedEnd) {
  Mesh mesh = test::mesh_of({{0, 0}, {1, 0}, {0, 1}, {7, 7}}, {{0, 1, 2}});
  mesh.add_edge(VertexId(0U), VertexId(3U));
  expect_names(mesh, "edge 0 has a deleted end");
}

}  // namespace
}  // namespace quarry
