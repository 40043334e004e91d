// What OpenGeoSys and MOOSE ask of files.
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/mesh/single_edges.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

TEST(SingleEdges, TakeThePieceOfSeveralLinesOnceWithItsSmallestNumber) {
  const Mesh mesh = make_sample_mesh({.size = 9});
  const LiveNumbering numbering(mesh);
  const MeshFileTags tags(mesh);
  std::map<std::int32_t, int> all, interior;
  for (const std::uint32_t i : single_edges(mesh, numbering)) ++all[tags.constraint(numbering.edges()[i])];
  for (const std::uint32_t i : fracture_edges(mesh, numbering))
    ++interior[tags.constraint(numbering.edges()[i])];
  // Line 5 runs along line 3; line 0 and edges without a number are the boundary.
  EXPECT_EQ(all, (std::map<std::int32_t, int>{{-1, 18}, {0, 18}, {3, 9}}));
  EXPECT_EQ(interior, (std::map<std::int32_t, int>{{3, 9}}));
}

TEST(OpenGeoSysFile, HasMaterialsAndInteriorLinesAlone) {
  const TemporaryFolder folder;
  const Mesh mesh = make_sample_mesh({.size = 9});
  write_mesh(folder.file("a.vtu"), mesh,
             {.fields = {{"options", "x"}}, .consumer = MeshConsumer::kOpenGeoSys});
  const std::string text = file_content(folder.file("a.vtu"));
  EXPECT_NE(text.find("type=\"Int32\" Name=\"MaterialIDs\""), std::string::npos);
  EXPECT_EQ(text.find("FieldData"), std::string::npos);
  const Mesh back = read_mesh(folder.file("a.vtu"));
  EXPECT_EQ(back.edge_slots(), 9U);
  EXPECT_EQ(back.face_slots(), mesh.face_slots());
  for (const EdgeId e : back.edges()) EXPECT_EQ(MeshFileTags(back).constraint(e), 3);
}

TEST(OpenGeoSysFile, HasNoTextsOfGroupsOfLines) {
  const TemporaryFolder folder;
  write_mesh(folder.file("a.vtu"), make_sample_mesh({.size = 9}),
             {.groups = {{"set", {"joints"}}}, .consumer = MeshConsumer::kOpenGeoSys});
  EXPECT_EQ(file_content(folder.file("a.vtu")).find("String"), std::string::npos);
}

TEST(MooseFile, HasOneGroupAnEntityAndNoNumberTwice) {
  const TemporaryFolder folder;
  write_mesh(folder.file("a.msh"), make_sample_mesh({.size = 9}), {.consumer = MeshConsumer::kMoose});
  std::istringstream text(file_content(folder.file("a.msh")));
  std::string line;
  const auto find = [&](const std::string& section) {
    while (line != section) ASSERT_TRUE(std::getline(text, line)) << section;
  };
  find("$PhysicalNames");
  std::size_t count = 0;
  text >> count;
  std::set<int> tags;
  std::map<std::string, int> dimension_of;
  for (std::size_t i = 0; i < count; ++i) {
    int dimension = 0, tag = 0;
    std::string name;
    text >> dimension >> tag >> name;
    EXPECT_TRUE(tags.insert(tag).second) << tag;
    dimension_of[name] = dimension;
  }
  EXPECT_EQ(dimension_of, (std::map<std::string, int>{{"\"outer_boundary\"", 1},
                                                      {"\"line_0\"", 1},
                                                      {"\"line_3\"", 1},
                                                      {"\"line_5\"", 1},
                                                      {"\"line_3_lower_dimensional_block\"", 1},
                                                      {"\"region_0\"", 2},
                                                      {"\"region_1\"", 2}}));
  find("$Entities");
  std::size_t points = 0, curves = 0, surfaces = 0, volumes = 0;
  text >> points >> curves >> surfaces >> volumes;
  EXPECT_EQ(curves + surfaces, tags.size());
  std::set<int> used;
  for (std::size_t i = 0; i < curves + surfaces; ++i) {
    int entity = 0, groups = 0, tag = 0, borders = -1;
    double bound = 0;
    text >> entity;
    for (int k = 0; k < 6; ++k) text >> bound;
    text >> groups >> tag >> borders;
    EXPECT_EQ(groups, 1);
    EXPECT_EQ(borders, 0);
    used.insert(tag);
  }
  EXPECT_EQ(used, tags);
}

TEST(Consumers, AskForTheirFormat) {
  EXPECT_NO_THROW(check_writable_for("a.vtu", MeshConsumer::kOpenGeoSys));
  EXPECT_NO_THROW(check_writable_for("a.msh", MeshConsumer::kMoose));
  EXPECT_THROW(check_writable_for("a.msh", MeshConsumer::kOpenGeoSys), Error);
  EXPECT_THROW(check_writable_for("a.vtu", MeshConsumer::kMoose), Error);
}

}  // namespace
}  // namespace quarry
