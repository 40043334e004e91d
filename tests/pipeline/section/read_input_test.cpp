#include "pipeline/section/read_input.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

class SectionInputs : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "quarry_input_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string save(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static SectionInput read(const SectionOptions& options) { return read_section_input(options, Progress()); }
  // The error that reading ends in: its exit code and message.
  static std::string error_of(const SectionOptions& options) {
    try {
      (void)read(options);
    } catch (const Error& error) {
      return std::to_string(error.exit_code()) + " " + error.message();
    }
    return "no error";
  }

  const std::string degrees_ = "lon,lat,id\n33.1,-10.2,1\n33.2,-10.3,1\n";
  std::filesystem::path folder_;
};

#define EXPECT_PART(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(SectionInputs, DegreesAreRefusedProjectedOrTakenAsTheyAre) {
  SectionOptions options;
  options.inputs = {save("a.csv", degrees_)};
  options.size = 1;
  const std::string message = error_of(options);
  EXPECT_PART(message, "3 ");
  EXPECT_PART(message, "--project");
  EXPECT_PART(message, "--as-is");
  options.as_is = true;
  EXPECT_EQ(read(options).lines.lines[LineId(0U)].points[0], (Vec2{33.1, -10.2}));
  options.as_is = false;
  options.project = true;
  const SectionInput projected = read(options);
  EXPECT_EQ(projected.projected, "EPSG:32736 (WGS 84 / UTM zone 36S)");
  EXPECT_GT(projected.lines.lines[LineId(0U)].points[0].y, 8e6);
  EXPECT_EQ(projected.lines.systems[0].definition, "OGC:CRS84");
  options.inputs = {save("b.txt", "0 0 1 1\n")};
  EXPECT_PART(error_of(options), "2 --project");
}

TEST_F(SectionInputs, TheOutlineIsProjectedWithTheLines) {
  SectionOptions options;
  options.inputs = {save("a.csv", degrees_)};
  options.boundary = save("frame.csv", "lon,lat\n33,-10\n34,-10\n34,-11\n33,-10\n");
  options.project = true;
  EXPECT_GT(read(options).boundary.value().lines[LineId(0U)].points[0].y, 8e6);
  options.project = false;
  options.inputs = {save("b.txt", "0 0 1 1\n")};
  EXPECT_PART(error_of(options), "frame.csv");
}

TEST_F(SectionInputs, DifferentSystemsAreTold) {
  SectionOptions options;
  options.inputs = {save("a.wkt", "SRID=3067;LINESTRING (0 0, 1 1)"),
                    save("b.wkt", "SRID=32635;LINESTRING (0 0, 1 1)")};
  ASSERT_EQ(read(options).notes.size(), 1U);
  EXPECT_PART(read(options).notes[0], "different coordinate systems");
  options.inputs[1] = save("c.txt", "0 0 1 1\n");
  EXPECT_TRUE(read(options).notes.empty());
}

TEST_F(SectionInputs, LinesInVerticalPlanesAreTakenByPlane) {
  const std::string lines =
      "LINESTRING Z (5 0 1, 5 2 3)\nLINESTRING Z (7 0 1, 7 1 8)\nLINESTRING Z (5 4 1, 5 5 1, 5 6 2)\n"
      "LINESTRING Z (1 9 0, 2 9 1)\n";
  SectionOptions options;
  options.inputs = {save("a.wkt", lines)};
  const std::string message = error_of(options);
  EXPECT_PART(message, "3 ");
  EXPECT_PART(message, "--section: x=5 (2 lines), x=7 (1 line), y=9 (1 line)");
  options.section = "x=5";
  const SectionInput input = read(options);
  ASSERT_EQ(input.lines.lines.size(), 2U);
  EXPECT_EQ(input.lines.lines[LineId(0U)].points, (std::vector<Vec2>{{0, 1}, {2, 3}}));
  options.section = "y=9";
  EXPECT_EQ(read(options).lines.lines[LineId(0U)].points, (std::vector<Vec2>{{1, 0}, {2, 1}}));
  options.section = "x=6";
  EXPECT_PART(error_of(options), "3 ");
  for (const char* const bad : {"z=1", "x", "x=", "x=1e", "x=nan"}) {
    options.section = bad;
    EXPECT_PART(error_of(options), "2 --section");
  }
  options.section.clear();
  options.inputs = {save("b.wkt", lines + "LINESTRING Z (0 0 1, 1 1 2)")};
  EXPECT_EQ(read(options).lines.lines.size(), 5U) << "one line that is seen from above is a map";
  options.inputs = {save("c.wkt", "LINESTRING Z (5 0 1, 5 2 1)")};
  EXPECT_EQ(read(options).lines.lines.size(), 1U) << "level lines are a map";
}

}  // namespace
}  // namespace quarry
