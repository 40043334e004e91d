#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/mesh/vtu_writer.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

VertexId vertex(std::size_t i) { return VertexId(i); }

// A quad and two triangles; the constraint 7 between the regions 0 and 1.
Mesh tiny_mesh() {
  const std::vector<FaceCorners> faces = {{vertex(0), vertex(1), vertex(4), vertex(3)},
                                          {vertex(1), vertex(2), vertex(5), VertexId()},
                                          {vertex(1), vertex(5), vertex(4), VertexId()}};
  Mesh mesh = build_mesh({0, 1, 2, 0, 1, 2}, {0, 0, 0, 1, 1.5, 1}, faces);
  mesh.add_tag<FaceId, std::int32_t>("region").values().raw() = {0, 1, 1};
  mesh.add_edge(vertex(1), vertex(4));
  mesh.add_tag<EdgeId, std::int32_t>("constraint", 7);
  mesh.add_tag<EdgeId, std::int32_t>("kind", kInteriorConstraint);
  return mesh;
}

class StoredVtu : public testing::TestWithParam<const char*> {};

TEST_P(StoredVtu, IsReadHoweverItsArraysAreStored) {
  const std::string path = std::string("tests/io/mesh/data/") + GetParam() + ".vtu";
  EXPECT_EQ(compared(read_mesh(path)), compared(tiny_mesh()));
}

INSTANTIATE_TEST_SUITE_P(All, StoredVtu,
                         testing::Values("ascii", "base64", "base64_zlib", "appended_base64",
                                         "appended_base64_zlib", "appended_raw_zlib"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(VtuWriter, WritesTheBytesOfTheGoldenFile) {
  const TemporaryFolder folder;
  const std::vector<double> quality = {0.5, 0.25, 0.125};
  MeshWriteOptions options;
  options.fields = {{"quarry_version", "0.1.0"}};
  options.scaled_jacobian = quality;
  write_vtu(folder.file("tiny.vtu"), tiny_mesh(), options);
  EXPECT_TRUE(file_content(folder.file("tiny.vtu")) == file_content("tests/io/mesh/data/golden.vtu"))
      << "if the format was meant to change, replace tests/io/mesh/data/golden.vtu";
}

TEST(VtuWriter, WritesSmallerFilesWhenCompressed) {
  const TemporaryFolder folder;
  const Mesh mesh = make_sample_mesh({.size = 100});
  MeshWriteOptions options;
  write_vtu(folder.file("raw.vtu"), mesh, options);
  options.compress = true;
  write_vtu(folder.file("zlib.vtu"), mesh, options);
  EXPECT_LT(2 * file_content(folder.file("zlib.vtu")).size(), file_content(folder.file("raw.vtu")).size());
}

TEST(VtuReader, NamesTheArrayThatIsMissing) {
  const TemporaryFolder folder;
  std::string text = file_content("tests/io/mesh/data/ascii.vtu");
  text.replace(text.find("connectivity"), 12, "conn");
  const std::string path = folder.file("broken.vtu", text);
  try {
    static_cast<void>(read_mesh(path));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(error.message(), path + ": the array Cells connectivity is missing");
  }
}

TEST(VtuReader, TakesTheGroupsOfOtherPrograms) {
  const TemporaryFolder folder;
  std::string text = file_content("tests/io/mesh/data/ascii.vtu");
  text.replace(text.find("region"), 6, "gmsh:physical");
  text.replace(text.find("0 1 1 -1"), 8, "0 1 1 7");
  text.replace(text.find("\"constraint\""), 12, "\"stress\"");
  EXPECT_EQ(compared(read_mesh(folder.file("a.vtu", text))), compared(tiny_mesh()));
}

TEST(VtuReader, RefusesVolumeCells) {
  const TemporaryFolder folder;
  std::string text = file_content("tests/io/mesh/data/ascii.vtu");
  text.replace(text.find("9 5 5 3"), 7, "10 5 5 3");
  EXPECT_THROW(static_cast<void>(read_mesh(folder.file("volume.vtu", text))), Error);
}

TEST(VtuReader, RefusesCoordinatesThatAreNotFinite) {
  const TemporaryFolder folder;
  std::string text = file_content("tests/io/mesh/data/ascii.vtu");
  text.replace(text.find("1.5"), 3, "nan");
  try {
    static_cast<void>(read_mesh(folder.file("nan.vtu", text)));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("point 4"), std::string::npos) << error.message();
  }
}

// The tiny mesh with a point, zones of its regions, and the set and aperture of its line.
Mesh grouped_mesh() {
  Mesh mesh = tiny_mesh();
  mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1)[vertex(2)] = 5;
  mesh.add_tag<FaceId, std::int32_t>(kZoneTag).values().raw() = {1, -1, 0};
  mesh.add_tag<EdgeId, std::int32_t>("set", 0);
  mesh.add_tag<EdgeId, double>(kApertureTag, 0.25);
  return mesh;
}

TEST(VtuReader, ReadsPointsGroupsAndAperturesBack) {
  const TemporaryFolder folder;
  MeshWriteOptions options;
  options.fields = {{"options", "size=1"}};
  options.groups = {{kZoneTag, {"clay", "north bank"}}, {"set", {"joints"}}, {"name", {"unused"}}};
  write_vtu(folder.file("a.vtu"), grouped_mesh(), options);
  ReadCells cells = read_cells(folder.file("a.vtu"));
  const std::vector<Grouping> groups = groupings_of(cells);
  ASSERT_EQ(groups.size(), 2U) << "what no face and no edge has is left out";
  EXPECT_EQ(groups[0].names, options.groups[0].names);
  const Mesh mesh = make_mesh("a.vtu", std::move(cells));
  EXPECT_EQ((mesh.find_tag<VertexId, std::int32_t>(kPointTag)[vertex(2)]), 5);
  EXPECT_EQ((mesh.find_tag<FaceId, std::int32_t>(kZoneTag).values().raw()),
            (std::vector<std::int32_t>{1, -1, 0}));
  const auto e = EdgeId(std::size_t{0});
  EXPECT_EQ((mesh.find_tag<EdgeId, std::int32_t>("set")[e]), 0);
  EXPECT_EQ((mesh.find_tag<EdgeId, double>(kApertureTag)[e]), 0.25);
  options.groups.pop_back();
  write_vtu(folder.file("b.vtu"), mesh, options);
  write_vtu(folder.file("c.vtu"), grouped_mesh(), options);
  EXPECT_TRUE(file_content(folder.file("b.vtu")) == file_content(folder.file("c.vtu")));
}

TEST(VtuReader, RefusesAGroupWithoutAName) {
  const TemporaryFolder folder;
  write_vtu(folder.file("a.vtu"), grouped_mesh(), {.groups = {{kZoneTag, {"clay"}}}});
  try {
    static_cast<void>(read_mesh(folder.file("a.vtu")));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find("a cell has zone 1, but there are 1 names"), std::string::npos)
        << error.message();
  }
}

}  // namespace
}  // namespace quarry
