#include "pipeline/section/line_tags.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/mesh/mesh_format.hpp"
#include "pipeline/section/section.hpp"

namespace quarry {
namespace {

class LineTags : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "quarry_tags_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string save(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static SectionResult mesh(const std::vector<std::string>& inputs) {
    SectionOptions options;
    options.inputs = inputs;
    options.size = 10;
    return mesh_section(options, Progress());
  }

  std::filesystem::path folder_;
};

TEST_F(LineTags, EachEdgeHasTheAttributesOfItsLine) {
  const SectionResult result =
      mesh({save("a.csv",
                 "line,x,y,name,set,aperture\n1,10,10,Main,faults,0.5\n1,90,80,,,\n2,10,50,,joints,\n2,95,55,"
                 ",,\n3,5,5,Other,joints,2\n3,95,5,,,\n"),
            save("frame.txt", "0 0 100 0 100 100 0 100 0 0\n")});
  ASSERT_EQ(result.groups.size(), 3U);
  EXPECT_EQ(result.groups[0].tag, "name");
  EXPECT_EQ(result.groups[0].names, (std::vector<std::string>{"Main", "Other"}));
  EXPECT_EQ(result.groups[1].names, (std::vector<std::string>{"faults", "joints"}));
  EXPECT_EQ(result.groups[2].names, (std::vector<std::string>{"a", "frame"}));
  const auto constraint = result.mesh.find_tag<EdgeId, std::int32_t>("constraint");
  const auto name = result.mesh.find_tag<EdgeId, std::int32_t>("name");
  const auto set = result.mesh.find_tag<EdgeId, std::int32_t>("set");
  const auto file = result.mesh.find_tag<EdgeId, std::int32_t>("file");
  const auto aperture = result.mesh.find_tag<EdgeId, double>("aperture");
  constexpr std::array kNames = {0, -1, 1, -1}, kSets = {0, 1, 1, -1}, kFiles = {0, 0, 0, 1};
  constexpr std::array kApertures = {0.5, -1.0, 2.0, -1.0};
  std::set<std::int32_t> seen;
  for (const EdgeId e : IdRange<EdgeId>(result.mesh.edge_slots())) {
    ASSERT_GE(constraint[e], 0);
    const auto line = static_cast<std::size_t>(constraint[e]);
    seen.insert(constraint[e]);
    EXPECT_EQ(name[e], kNames[line]);
    EXPECT_EQ(set[e], kSets[line]);
    EXPECT_EQ(file[e], kFiles[line]);
    EXPECT_EQ(std::isnan(aperture[e]) ? -1.0 : aperture[e], kApertures[line]);
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST_F(LineTags, ThereAreNoneWithoutAttributes) {
  const SectionResult result = mesh({save("a.txt", "0 0 50 50\n0 50 50 0\n")});
  ASSERT_EQ(result.groups.size(), 1U);
  EXPECT_EQ(result.groups[0].tag, "box_side");
  EXPECT_FALSE((result.mesh.find_tag<EdgeId, double>("aperture").valid()));
}

TEST_F(LineTags, GroupsOfLinesDoNotComeBackAsLines) {
  const SectionResult result =
      mesh({save("a.csv", "line,x,y,name,set\n1,10,10,Main,faults\n1,90,80,,\n2,10,50,,joints\n2,95,55,,\n"),
            save("b.txt", "0 0 100 0 100 100 0 100 0 0\n")});
  const auto edges_of = [](const Mesh& mesh) {
    std::multiset<std::int32_t> numbers;
    const MeshFileTags tags(mesh);
    for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots())) numbers.insert(tags.constraint(e));
    return numbers;
  };
  for (const char* const format : {"a.msh", "a.inp"}) {
    MeshWriteOptions options;
    options.groups = result.groups;
    const std::string path = (folder_ / format).string();
    write_mesh(path, result.mesh, options);
    EXPECT_EQ(edges_of(read_mesh(path)), edges_of(result.mesh)) << format;
  }
}

TEST_F(LineTags, FilesOfTheSameNameAreToldApart) {
  EXPECT_EQ(file_group_names({"x/faults.shp", "y/faults.geojson", "-"}),
            (std::vector<std::string>{"faults", "faults_2", "stdin"}));
}

}  // namespace
}  // namespace quarry
