// Lines of many formats through the command: what reaches the mesh and the report.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

using Json = nlohmann::json;

constexpr const char* kTraces =
    "line,x,y,name,set,aperture,material\n1,10,10,Main,faults,0.5,gouge\n1,90,80,,,,\n2,10,50,,joints,,\n2,"
    "95,55,,,,\n";
constexpr const char* kFrame = "0 0 100 0 100 100 0 100 0 0\n";

class LineInput : public testing::Test {
 protected:
  void expect_done(const std::vector<std::string>& arguments, const CommandOptions& options = {}) {
    const CommandResult result = run_quarry(arguments, options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  // With a file as standard input.
  static CommandOptions from(const std::string& file) {
    CommandOptions options;
    options.input = file;
    return options;
  }
  [[nodiscard]] Json report() const { return Json::parse(read_text(folder_ / "report.json")); }

  TestFolder folder_;
};

TEST_F(LineInput, StandardInputGivesTheSameMeshAsTheFile) {
  const std::string file = folder_.write("traces.csv", kTraces);
  expect_done({"mesh", file, "-o", folder_ / "a.vtu", "--size", "10"});
  expect_done({"mesh", "-", "-o", folder_ / "b.vtu", "--size", "10"}, from(file));
  EXPECT_EQ(read_text(folder_ / "a.vtu"), read_text(folder_ / "b.vtu"));
  expect_done({"clean", "-", "-o", folder_ / "c.geojson", "--size", "10"}, from(file));
  const CommandResult empty = run_quarry({"mesh", "-", "-o", folder_ / "d.vtu", "--size", "10"});
  EXPECT_EQ(empty.exit_code, 3);
  EXPECT_NE(empty.err.find("standard input: the file is empty"), std::string::npos) << empty.err;
}

TEST_F(LineInput, AttributesAndFilesAreInTheReport) {
  const std::string traces = folder_.write("traces.csv", kTraces);
  const std::string frame = folder_.write("frame.txt", kFrame);
  expect_done(
      {"mesh", traces, frame, "-o", folder_ / "a.vtu", "--size", "10", "--report", folder_ / "report.json"});
  const Json lines = report()["input"]["lines"];
  EXPECT_EQ(lines[0]["name"], "Main");
  EXPECT_EQ(lines[0]["aperture"], 0.5);
  EXPECT_EQ(lines[0]["material"], "gouge");
  EXPECT_EQ(lines[1]["set"], "joints");
  EXPECT_FALSE(lines[1].contains("aperture"));
  EXPECT_EQ(lines[1]["file"], 0);
  EXPECT_EQ(lines[2]["file"], 1);
}

TEST_F(LineInput, GroupsOfLinesHaveNamesInGmshAndAbaqusFiles) {
  const std::string traces = folder_.write("traces.csv", kTraces);
  const std::string frame = folder_.write("frame.txt", kFrame);
  for (const std::string format : {"msh", "inp"}) {
    const std::string mesh = folder_ / ("a." + format);
    expect_done({"mesh", traces, frame, "-o", mesh, "--size", "10"});
    const std::string text = read_text(mesh);
    for (const char* const name : {"line_0", "line_2", "name_Main", "set_faults", "set_joints",
                                   "material_gouge", "file_traces", "file_frame"})
      EXPECT_NE(text.find(name), std::string::npos) << name;
  }
}

TEST_F(LineInput, CleanedLinesKeepTheirAttributesAndTheCoordinateSystem) {
  const std::string traces =
      folder_.write("traces.wkt.csv",
                    "wkt,name,aperture\n\"SRID=3067;LINESTRING (10 10, 90 80)\",\"say \"\"A\"\"\",0.5\n"
                    "\"SRID=3067;LINESTRING (10 80, 90 10)\",,\n");
  expect_done({"clean", traces, "-o", folder_ / "clean.geojson", "--size", "10"});
  const Json clean = Json::parse(read_text(folder_ / "clean.geojson"));
  EXPECT_EQ(clean["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::3067");
  for (const Json& feature : clean["features"]) {
    const Json& properties = feature["properties"];
    const bool named = properties["lines"] == Json::array({0});
    EXPECT_EQ(properties.contains("name"), named);
    if (named) {
      EXPECT_EQ(properties["name"], "say \"A\"");
      EXPECT_EQ(properties["aperture"], 0.5);
    }
  }
  expect_done({"mesh", folder_ / "clean.geojson", "-o", folder_ / "a.msh", "--size", "10"});
  EXPECT_NE(read_text(folder_ / "a.msh").find("name_say 'A'"), std::string::npos);
}

TEST_F(LineInput, DegreesAreRefusedInOneLineThatSaysWhatHelps) {
  const std::string file = folder_.write("map.csv", "lon,lat,id\n33.1,-10.2,1\n33.2,-10.3,1\n");
  const std::string out = folder_ / "a.vtu";
  const CommandResult refused = run_quarry({"mesh", file, "-o", out, "--size", "500"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_EQ(refused.error_lines(), 1U) << refused.err;
  EXPECT_NE(refused.err.find("--project"), std::string::npos) << refused.err;
  expect_done({"mesh", file, "-o", out, "--size", "500", "--project", "--report", folder_ / "report.json"});
  EXPECT_EQ(report()["options"]["project"], "EPSG:32736 (WGS 84 / UTM zone 36S)");
  EXPECT_EQ(report()["input"]["coordinate_systems"][0], "OGC:CRS84");
  expect_done({"mesh", file, "-o", out, "--size", "0.01", "--as-is"});
  EXPECT_EQ(run_quarry({"mesh", file, "-o", out, "--size", "1", "--as-is", "--project"}).exit_code, 2);
  expect_done({"clean", file, "-o", folder_ / "a.geojson", "--size", "500", "--project"});
  EXPECT_NE(read_text(folder_ / "a.geojson").find("EPSG::32736"), std::string::npos);
}

}  // namespace
}  // namespace quarry
