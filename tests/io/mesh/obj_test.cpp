#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

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

void expect_error(const std::string& text, const std::string& message) {
  const TemporaryFolder folder;
  try {
    static_cast<void>(read_mesh(folder.file("a.obj", text)));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
  }
}

TEST(ObjReader, NamesTheLineOfABrokenNumber) {
  expect_error("v 0 0 0\nv 1 zero 0\n", "a.obj:2: a coordinate is expected, not \"zero\"");
}
TEST(ObjReader, NamesAPointThatDoesNotExist) {
  expect_error("v 0 0 0\nf 1 2 3\n", "a.obj:2: point 2 does not exist; 1 points come before this line");
  expect_error("v 0 0 0\nf -2 1 1\n", "a.obj:2: point -2 does not exist");
}
TEST(ObjReader, RefusesFacesOfFiveCorners) {
  expect_error("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3 4 5\n",
               "a.obj:6: a face has more than 4 corners");
}
TEST(ObjReader, NamesAnEdgeOfThreeFaces) {
  expect_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
               "has three faces");
}

}  // namespace
}  // namespace quarry
