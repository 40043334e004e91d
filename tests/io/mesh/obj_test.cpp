#include "tests/io/mesh/read_error.hpp"

namespace quarry {
namespace {

TEST(ObjReader, ReadsAllFormsOfCorners) {
  const TemporaryFolder folder;
  const Mesh mesh =
      read_mesh(folder.file("a.obj",
                            "# comment\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 1.0\nv +1 1 0\nv 0 1 0\nv 2 0 0\n"
                            "vt 0 0\nvn 0 0 1\ng rock layer\nf 1/1/1 2/1/1 3//1 4\ng region_8\n"
                            "f -4/1 -1 -3\nl 1 2 5\n"));
  ASSERT_EQ(mesh.face_slots(), 2U);
  EXPECT_EQ(mesh.corner_count(FaceId(std::size_t{0})), 4);
  EXPECT_EQ(mesh.corner(FaceId(std::size_t{1}), 0).value(), 1U);
  EXPECT_EQ(mesh.corner(FaceId(std::size_t{1}), 1).value(), 4U);
  const MeshFileTags tags(mesh);
  EXPECT_EQ(tags.region(FaceId(std::size_t{0})), 0);
  EXPECT_EQ(tags.region(FaceId(std::size_t{1})), 8);
  EXPECT_EQ(mesh.edge_slots(), 2U);
  EXPECT_EQ(tags.constraint(EdgeId(std::size_t{0})), -1);
  EXPECT_EQ(tags.kind(EdgeId(std::size_t{0})), kOuterBoundary);
}

TEST(ObjReader, ReadsPointsOfThePlane) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.file("a.obj", "v 0 0\r\nv 1 0\r\nv 0 1\r\nf 1 2 3\r\n"));
  EXPECT_TRUE(mesh.planar());
  EXPECT_EQ(mesh.face_slots(), 1U);
}

TEST(ObjReader, KeepsGroupsAndObjectsAsRegionsWithTheirNames) {
  const ReadCells cells = read_text_as(
      "a.obj",
      "v 0 0\nv 1 0\nv 0 1\nv 1 1\ng line_4 outer\nl 1 2\no upper\nf 1 2 3\ng\nusemtl rock\ns off\n"
      "g lower\nf 2 4 3\nl 2 4\ng outer_boundary\nl 4 3 1\n");
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(cells.names.regions.at(0), "upper");
  EXPECT_EQ(cells.names.regions.at(1), "lower");
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{4, 4, -1, -1}));
}

TEST(ObjReader, NamesTheLineOfABrokenNumber) {
  expect_read_error("a.obj", "v 0 0 0\nv 1 zero 0\n", "a.obj:2: a coordinate is expected, not \"zero\"");
}
TEST(ObjReader, NamesAPointThatDoesNotExist) {
  expect_read_error("a.obj", "v 0 0 0\nf 1 2 3\n",
                    "a.obj:2: point 2 does not exist; 1 points come before this line");
  expect_read_error("a.obj", "v 0 0 0\nf -2 1 1\n", "a.obj:2: point -2 does not exist");
}
TEST(ObjReader, ReadsNoNumbersFromTheNextLine) {
  expect_read_error("a.obj", "v 0\n0 0\n", "a.obj:1: a coordinate is missing");
  expect_read_error("a.obj", "v 0 0 0\nv 1 0 0\nl\n1 2\n", "a.obj:3: the number of a point is missing");
  expect_read_error("a.obj", "v 0 0 0\nf 1 1\n1\n", "a.obj:2: a face has 2 corners");
}
TEST(ObjReader, RefusesCoordinatesThatAreNotFinite) {
  expect_read_error("a.obj", "v 0 0 0\nv 1 nan 0\n", "a.obj:2: a coordinate is not a finite number");
  expect_read_error("a.obj", "v 0 0 1e999\n", "a.obj:1: a coordinate is expected, not \"1e999\"");
}
TEST(ObjReader, RefusesWhatItWouldMissAndWhatIsNoObj) {
  expect_read_error("a.obj", "cstype bspline\nsurf 0 1 0 1\n", "a.obj:2: free-form curves and surfaces");
  expect_read_error("a.obj", std::string("\0\0\0\0", 4), "a.obj:1: ");
  expect_read_error("a.obj",
                    "v 0 0 0\n\x7f"
                    "ELF\n",
                    "a.obj:2: ");
  expect_read_error("a.obj", "{\"type\": 1}\n", "is no key of an .obj file");
}
TEST(ObjReader, RefusesFacesOfFiveCorners) {
  expect_read_error("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3 4 5\n",
                    "a.obj:6: a face has more than 4 corners");
}
TEST(ObjReader, NamesAnEdgeOfThreeFacesInThePlane) {
  expect_read_error("a.obj", "v 0 0\nv 1 0\nv 0 1\nv 0 -1\nv 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
                    "has three faces");
}

TEST(ObjReader, EndsSheetsWhereThreeMeetInSpaceAndWritesTheirPointsOnce) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.file(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\nl 1 2\n"));
  EXPECT_EQ(mesh.count_alive_vertices(), 9U);
  EXPECT_EQ(mesh.edge_slots(), 1U);
  write_mesh(folder.file("b.obj"), mesh, {});
  const ReadCells cells = read_cells(folder.file("b.obj"));
  EXPECT_EQ(cells.x.size(), 5U);
  EXPECT_EQ(cells.faces.size(), 3U);
  EXPECT_EQ(cells.edges.size(), 1U);
}

}  // namespace
}  // namespace quarry
