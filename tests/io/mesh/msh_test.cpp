#include <array>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/mesh/msh_format.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

std::string output_of(const std::string& command) {
  std::string text;
  if (FILE* pipe = ::popen((command + " 2>&1").c_str(), "r")) {
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
      text.append(part.data(), count);
    ::pclose(pipe);
  }
  return text;
}

std::map<std::int32_t, int> faces_by_region(const Mesh& mesh) {
  std::map<std::int32_t, int> counts;
  for (const FaceId f : mesh.faces()) ++counts[MeshFileTags(mesh).region(f)];
  return counts;
}

class Gmsh : public testing::Test {
 protected:
  void SetUp() override {
    if (output_of("command -v gmsh").empty()) GTEST_SKIP() << "gmsh is not installed";
  }
  TemporaryFolder folder_;
};

TEST_F(Gmsh, OpensWhatIsWritten) {
  const Mesh mesh = make_sample_mesh({.size = 9});
  write_msh(folder_.file("mesh.msh"), mesh, {.fields = {{"quarry_version", "0.1.0"}}});
  const std::string said =
      output_of("gmsh -format msh41 -o " + folder_.file("again.msh") + " -0 " + folder_.file("mesh.msh"));
  EXPECT_EQ(said.find("Error"), std::string::npos) << said;
  EXPECT_EQ(said.find("Warning"), std::string::npos) << said;
  const Mesh again = read_mesh(folder_.file("again.msh"));
  // Gmsh itself writes 16 digits, so that coordinates differ in the last bits: count what is in each group.
  EXPECT_EQ(faces_by_region(again), faces_by_region(mesh));
}

TEST_F(Gmsh, WritesWhatCanBeRead) {
  const std::string geometry =
      folder_.file("square.geo",
                   "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 2, 1};\n"
                   "Physical Surface(\"rock\") = {1};\nPhysical Curve(\"line_4\") = {1};\n"
                   "Mesh.MeshSizeMax = 0.2;\n");
  for (const char* format : {"msh41", "msh22", "msh41 -bin", "msh22 -bin"}) {
    const std::string path = folder_.file("square.msh");
    const std::string said =
        output_of(std::string("gmsh -2 -format ") + format + " -o " + path + " " + geometry);
    const Mesh mesh = read_mesh(path);
    EXPECT_GT(mesh.count_alive_faces(), 50U) << said;
    ASSERT_GT(mesh.edge_slots(), 5U);
    const MeshFileTags tags(mesh);
    EXPECT_EQ(tags.constraint(EdgeId(std::size_t{0})), 4);
    EXPECT_EQ(tags.kind(EdgeId(std::size_t{0})), kOuterBoundary);
  }
}

constexpr const char* kOldMesh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 5 \"line_2\"\n2 6 "
    "\"region_1\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n$EndNodes\n"
    "$Elements\n3\n1 1 2 5 1 10 20\n2 15 2 0 1 10\n3 3 2 6 1 10 20 30 40\n$EndElements\n";

TEST(MshReader, ReadsTheOldFormat) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.file("old.msh", kOldMesh));
  const MeshFileTags tags(mesh);
  ASSERT_EQ(mesh.face_slots(), 1U);
  EXPECT_EQ(tags.region(FaceId(std::size_t{0})), 1);
  ASSERT_EQ(mesh.edge_slots(), 1U);
  EXPECT_EQ(tags.constraint(EdgeId(std::size_t{0})), 2);
  EXPECT_EQ(tags.kind(EdgeId(std::size_t{0})), kOuterBoundary);
}

TEST(MshReader, KeepsTheNamesAndTagsOfGroups) {
  const TemporaryFolder folder;
  std::string text = kOldMesh;
  text.replace(text.find("line_2"), 6, "main fault");
  text.replace(text.find("1 1 2 5 1"), 9, "1 1 2 3 1");
  const ReadCells cells = read_cells(folder.file("old.msh", text));
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{3})) << "a group without a name keeps its tag";
  EXPECT_TRUE(cells.names.lines.empty()) << "no line is in the named group";

  text.replace(text.find("1 1 2 3 1"), 9, "1 1 2 5 1");
  ReadCells named = read_cells(folder.file("old.msh", text));
  EXPECT_EQ(named.constraints, (std::vector<std::int32_t>{0}));
  EXPECT_EQ(named.names.lines.at(0), "main fault");
  const GroupNames names = named.names;
  const Mesh mesh = make_mesh("old.msh", std::move(named));
  write_mesh(folder.file("new.msh"), mesh, {.names = names});
  EXPECT_EQ(read_cells(folder.file("new.msh")).names.lines.at(0), "main fault");
}

TEST(MshReader, GivesNamesTheNumbersThatNoGroupOfOursHas) {
  const TemporaryFolder folder;
  std::string text = kOldMesh;
  text.replace(text.find("3 3 2 6 1 10 20 30 40"), 21, "3 2 2 6 1 10 20 30\n4 2 2 7 1 10 30 40");
  text.replace(text.find("$Elements\n3"), 11, "$Elements\n4");
  text.replace(text.find("2\n1 5 \"line_2\"\n2 6 \"region_1\""), 30,
               "2\n2 7 \"region_0\"\n2 6 \"sandstone\"");
  const ReadCells cells = read_cells(folder.file("old.msh", text));
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(cells.names.regions.at(1), "sandstone");
}

// A triangle, and a line of two groups along one of its edges.
constexpr const char* kNewMesh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"outer_boundary\"\n1 2 \"line_3\"\n"
    "1 4 \"line_8\"\n$EndPhysicalNames\n$Entities\n0 1 1 0\n1 0 0 0 1 1 0 3 1 2 4 0\n"
    "5 0 0 0 1 1 0 0 0\n$EndEntities\n$Nodes\n1 3 1 3\n2 5 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n"
    "$EndNodes\n$Elements\n2 2 1 2\n1 1 1 1\n1 1 2\n2 5 2 1\n2 1 2 3\n$EndElements\n";

TEST(MshReader, ReadsALineOnceForEachOfItsGroups) {
  const TemporaryFolder folder;
  const ReadCells cells = read_cells(folder.file("new.msh", kNewMesh));
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{3, 8}));
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0}));
}

// Found by fuzzing.
// Gmsh saves an element in the old format once for each of its groups.
TEST(MshReader, JoinsTheElementsOfSeveralGroupsInTheOldFormat) {
  const TemporaryFolder folder;
  const std::string path = folder.file(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n1 1 \"outer_boundary\"\n1 2 \"line_4\"\n"
      "1 3 \"set_joints\"\n1 4 \"set_faults\"\n2 5 \"region_1\"\n2 6 \"ore\"\n1 7 \"line_6\"\n"
      "$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
      "$Elements\n10\n1 1 2 1 1 1 2\n2 1 2 2 1 1 2\n3 1 2 3 1 1 2\n4 1 2 7 1 1 2\n5 1 2 4 2 2 3\n6 1 2 1 3 4 "
      "1\n"
      "7 3 2 5 1 1 2 5 4\n8 3 2 5 1 2 3 6 5\n9 3 2 6 1 1 2 5 4\n10 3 2 6 1 2 3 6 5\n$EndElements\n");
  const ReadCells cells = read_cells(path);
  EXPECT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{1, 1}));
  ASSERT_EQ(cells.edges.size(), 4U);
  EXPECT_EQ(cells.constraints[0], 4);
  EXPECT_EQ(cells.constraints[1], 6);
  EXPECT_EQ(cells.names.lines.at(cells.constraints[2]), "set_faults") << "no line beside it";
  EXPECT_EQ(cells.constraints[3], -1);
}

TEST(MshReader, RefusesAFaceThatIsThereTwiceInOneRegion) {
  const TemporaryFolder folder;
  const std::string path = folder.file(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n2\n"
      "1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 3\n$EndElements\n");
  EXPECT_EQ(read_cells(path).faces.size(), 2U);
  EXPECT_THROW(static_cast<void>(read_mesh(path)), Error);
}

TEST(MshReader, RefusesElementsOfAnotherDimensionThanTheirEntity) {
  const TemporaryFolder folder;
  std::string text = kNewMesh;
  text.replace(text.find("2 5 2 1\n2 1 2 3"), 7, "1 1 2 1");
  try {
    static_cast<void>(read_cells(folder.file("new.msh", text)));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find("elements of type 2 in an entity of dimension 1"), std::string::npos)
        << error.message();
  }
}

void expect_error(const std::string& from, const std::string& to, const std::string& message) {
  const TemporaryFolder folder;
  std::string text = kOldMesh;
  text.replace(text.find(from), from.size(), to);
  try {
    static_cast<void>(read_mesh(folder.file("old.msh", text)));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
  }
}

TEST(MshReader, NamesTheLineOfABrokenNumber) {
  expect_error("30 1 1 0", "30 1 x 0", "old.msh:13: a coordinate is expected, not \"x\"");
}
TEST(MshReader, NamesANodeThatDoesNotExist) {
  expect_error("10 20 30 40\n", "10 20 31 40\n", "node 31 does not exist");
}
TEST(MshReader, RefusesBinaryFilesOfOtherMachines) {
  expect_error("2.2 0 8\n", std::string("2.2 1 8\n\0\0\0\1\n", 13), "save it as ASCII");
}
TEST(MshReader, RefusesANodeThatIsGivenTwice) {
  expect_error("20 1 0 0", "10 1 0 0", "node 10 is given twice");
}

// Bytes as a program of this machine writes them.
class Bytes {
 public:
  template <class Number>
  Bytes& add(std::initializer_list<Number> values) {
    for (const Number value : values) text_.append(reinterpret_cast<const char*>(&value), sizeof(Number));
    return *this;
  }
  Bytes& add(const std::string& text) {
    text_ += text;
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

using Ints = std::initializer_list<std::int32_t>;
using Sizes = std::initializer_list<std::uint64_t>;
using Doubles = std::initializer_list<double>;

constexpr const char* kNames = "$PhysicalNames\n2\n1 5 \"line_2\"\n2 6 \"region_1\"\n$EndPhysicalNames\n";

void expect_square(const ReadCells& cells) {
  EXPECT_EQ(cells.x, (std::vector<double>{0, 10, 10, 0}));
  EXPECT_EQ(cells.y, (std::vector<double>{0, 0, 10, 10}));
  ASSERT_EQ(cells.faces.size(), 1U);
  EXPECT_EQ(cells.faces[0][2].value(), 2U);
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{1}));
  ASSERT_EQ(cells.edges.size(), 1U);
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{2}));
}

TEST(MshReader, ReadsTheOldFormatInBinary) {
  Bytes file;
  file.add("$MeshFormat\n2.2 1 8\n").add(Ints{1}).add("\n$EndMeshFormat\n").add(kNames).add("$Nodes\n4\n");
  // 10 is the end of a line in text.
  file.add(Ints{10}).add(Doubles{0, 0, 0}).add(Ints{2}).add(Doubles{10, 0, 0});
  file.add(Ints{3}).add(Doubles{10, 10, 0}).add(Ints{4}).add(Doubles{0, 10, 0}).add("\n$EndNodes\n");
  file.add("$Elements\n2\n").add(Ints{1, 1, 2, 1, 5, 1, 10, 2}).add(Ints{3, 1, 2, 2, 6, 1, 10, 2, 3, 4});
  file.add("\n$EndElements\n");
  const TemporaryFolder folder;
  expect_square(read_cells(folder.file("a.msh", file.text())));
}

TEST(MshReader, ReadsTheNewFormatInBinary) {
  Bytes file;
  file.add("$MeshFormat\n4.1 1 8\n").add(Ints{1}).add("\n$EndMeshFormat\n").add(kNames);
  file.add("$Entities\n").add(Sizes{1, 1, 1, 0}).add(Ints{7}).add(Doubles{0, 0, 0}).add(Sizes{0});
  file.add(Ints{3})
      .add(Doubles{0, 0, 0, 10, 10, 0})
      .add(Sizes{1})
      .add(Ints{5})
      .add(Sizes{2})
      .add(Ints{7, -7});
  file.add(Ints{4}).add(Doubles{0, 0, 0, 10, 10, 0}).add(Sizes{1}).add(Ints{6}).add(Sizes{1}).add(Ints{3});
  file.add("\n$EndEntities\n$Nodes\n").add(Sizes{1, 4, 1, 10}).add(Ints{2, 4, 0}).add(Sizes{4, 10, 2, 3, 4});
  file.add(Doubles{0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0})
      .add("\n$EndNodes\n$Elements\n")
      .add(Sizes{2, 2, 1, 2});
  file.add(Ints{1, 3, 1}).add(Sizes{1, 1, 10, 2}).add(Ints{2, 4, 3}).add(Sizes{1, 2, 10, 2, 3, 4});
  file.add("\n$EndElements\n");
  const TemporaryFolder folder;
  expect_square(read_cells(folder.file("a.msh", file.text())));
  // Cut anywhere it is an error, and nothing worse.
  for (std::size_t size = 0; size < file.text().size() - 1; ++size)
    EXPECT_THROW(static_cast<void>(read_cells(folder.file("b.msh", file.text().substr(0, size)))), Error)
        << size;
}

TEST(MshReader, RefusesUnknownVersions) {
  expect_error("2.2 0 8", "4.0 0 8", "Gmsh format 4.0 is not known");
}
TEST(MshReader, RefusesVolumeElements) {
  expect_error("3 3 2 6", "3 4 2 6", "element type 4 is not supported");
}
TEST(MshReader, RefusesFilesWithoutAFormat) {
  expect_error("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "", "no $MeshFormat");
}

TEST(MshReader, ReadsPhysicalPointsOfBothFormats) {
  const TemporaryFolder folder;
  std::string text = kOldMesh;
  text.replace(text.find("$Elements\n3"), 11, "$Elements\n5\n8 15 2 9 1 20\n9 15 2 0 1 10");
  const ReadCells old = read_cells(folder.file("old.msh", text));
  ASSERT_EQ(old.point_numbers, (std::vector<std::int32_t>{9})) << "a point in no group is none of ours";
  Mesh mesh = make_mesh("old.msh", old);
  write_mesh(folder.file("new.msh"), mesh, {.names = {.regions = {}, .lines = {}, .points = {{9, "well"}}}});
  const ReadCells cells = read_cells(folder.file("new.msh"));
  ASSERT_EQ(cells.points.size(), 1U);
  EXPECT_EQ(cells.names.points.at(cells.point_numbers[0]), "well");
  EXPECT_EQ(cells.x[cells.points[0].value()], old.x[old.points[0].value()]);
}

}  // namespace
}  // namespace quarry
