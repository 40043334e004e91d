// Output files appear whole or not at all, and are looked at before the work starts.
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

void expect_failure(const std::vector<std::string>& arguments, int code, const std::string& word) {
  const CommandResult result = run_quarry(arguments);
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
}

nlohmann::json quality_of(const std::string& mesh) {
  return nlohmann::json::parse(run_quarry({"quality", mesh, "--json"}).out);
}

TEST(Outputs, ThatCannotBeWrittenAreToldBeforeTheWork) {
  const TestFolder folder;
  const std::string lost = folder / "no/such/folder/out";
  // The input is broken as well: that the output is told shows that it was looked at first.
  const std::string broken = folder.write("broken.geojson", "{");
  expect_failure({"mesh", broken, "-o", lost + ".vtu", "--size", "5"}, 7, "out.vtu");
  expect_failure({"mesh", broken, "-o", folder / "out.vtu", "--report", lost + ".json", "--size", "5"}, 7,
                 "out.json");
  expect_failure({"clean", broken, "-o", lost + ".geojson", "--size", "5"}, 7, "out.geojson");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"broken.geojson"});
}

TEST(Outputs, AFolderIsNoOutput) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "folder.vtu");
  expect_failure({"mesh", kDemoSection, "-o", folder / "folder.vtu", "--size", "20"}, 7, "folder.vtu");
}

TEST(Outputs, AnInputIsNoOutput) {
  const TestFolder folder;
  const std::string input = folder.write("lines.geojson", read_text(kDemoSection));
  expect_failure({"clean", input, "-o", input, "--size", "20"}, 2, "lines.geojson");
  expect_failure({"mesh", input, "-o", folder / "out.vtu", "--report", input, "--size", "20"}, 2,
                 "lines.geojson");
  EXPECT_EQ(read_text(input), read_text(kDemoSection));
}

TEST(Outputs, AStandardOutputThatTakesNothingIsToldWithExitCodeSeven) {
  const TestFolder folder;
  CommandOptions full;
  full.output = "/dev/full";
  const std::string mesh = folder.write("in.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  const std::string lines =
      folder.write("lines.geojson", R"({"type":"LineString","coordinates":[[0,0],[9,5]]})");
  const std::vector<std::vector<std::string>> commands = {
      {"quality", mesh},
      {"quality", mesh, "--json"},
      {"batch", lines, "-o", folder / "meshes", "--size", "2", "--quiet", "--json"}};
  for (const std::vector<std::string>& command : commands) {
    const CommandResult result = run_quarry(command, full);
    EXPECT_EQ(result.exit_code, 7) << command[0] << ": " << result.err;
    EXPECT_NE(result.err.find("standard output: cannot be written: No space left on device"),
              std::string::npos)
        << result.err;
  }
}

TEST(Outputs, TwoOutputsNeedTwoNames) {
  const TestFolder folder;
  expect_failure({"mesh", kDemoSection, "-o", folder / "a.vtu", "--report", folder / "a.vtu", "--size", "20"},
                 2, "a.vtu");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Outputs, EveryFormatIsWrittenAndReadAgain) {
  const TestFolder folder;
  for (const std::string name : {"out.vtu", "out.msh", "out.obj"}) {
    ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / name, "--size", "20"}).exit_code, 0) << name;
    EXPECT_EQ(run_quarry({"quality", folder / name}).exit_code, 0) << name;
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.msh", "out.obj", "out.vtu"}));
  ASSERT_EQ(run_quarry({"convert", folder / "out.msh", folder / "again.vtu"}).exit_code, 0);
  // Faces come in another order, by group, so that sums differ in their last digits.
  const nlohmann::json before = quality_of(folder / "out.vtu");
  const nlohmann::json after = quality_of(folder / "again.vtu");
  for (const char* key : {"quads", "vertices", "shortest_edge", "valence"})
    EXPECT_EQ(after[key], before[key]) << key;
}

TEST(Outputs, PicturesAreDrawnBesideTheMeshAndFromIt) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20", "--picture",
                        folder / "a.svg"})
                .exit_code,
            0);
  EXPECT_NE(read_text(folder / "a.svg").find("<svg"), std::string::npos);
  for (const std::string by : {"region", "quality", "constraint"}) {
    const std::string picture = folder / (by + ".png");
    ASSERT_EQ(run_quarry({"picture", folder / "out.vtu", "-o", picture, "--by", by}).exit_code, 0) << by;
    EXPECT_EQ(read_text(picture).substr(1, 3), "PNG") << by;
  }
  expect_failure({"picture", folder / "out.vtu", "-o", folder / "out.pdf"}, 2, "out.pdf");
  expect_failure(
      {"mesh", kDemoSection, "-o", folder / "b.vtu", "--size", "20", "--picture", folder / "b.pdf"}, 2,
      "b.pdf");
}

TEST(Outputs, PagesAreWrittenBesideTheMeshAndFromIt) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry(
                {"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20", "--page", folder / "a.html"})
                .exit_code,
            0);
  ASSERT_EQ(run_quarry({"picture", folder / "out.vtu", "-o", folder / "b.html"}).exit_code, 0);
  for (const char* name : {"a.html", "b.html"}) {
    const std::string page = read_text(folder / name);
    EXPECT_EQ(page.find("<!DOCTYPE html>"), 0U) << name;
    EXPECT_NE(page.find("scaled Jacobian, smallest"), std::string::npos) << name;
  }
  expect_failure({"mesh", kDemoSection, "-o", folder / "c.vtu", "--size", "20", "--page", folder / "c.htm"},
                 2, "c.htm");
}

TEST(Outputs, ASurfaceIsDrawnFromWhereItIsAskedFor) {
  const TestFolder folder;
  const std::string mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  ASSERT_EQ(run_quarry({"mesh", mesh, "-o", folder / "a.vtu", "--count", "30", "--picture", folder / "a.png"})
                .exit_code,
            0);
  ASSERT_EQ(run_quarry({"picture", folder / "a.vtu", "-o", folder / "b.png", "--view", "35", "25"}).exit_code,
            0);
  EXPECT_TRUE(read_text(folder / "a.png") == read_text(folder / "b.png"));
  ASSERT_EQ(run_quarry({"picture", folder / "a.vtu", "-o", folder / "c.png", "--view", "100", "60", "--up",
                        "y", "--around", "0", "0", "0", "0.6"})
                .exit_code,
            0);
  EXPECT_FALSE(read_text(folder / "a.png") == read_text(folder / "c.png"));
  expect_failure({"picture", folder / "a.vtu", "-o", folder / "d.png", "--around", "9", "9", "9", "1"}, 2,
                 "ball");
}

TEST(Outputs, AWindowBesideTheMeshIsToldWithTheBoxOfTheMesh) {
  const TestFolder folder;
  const std::string mesh = folder.write("a.obj", "v 1 2\nv 3 2\nv 3 5\nv 1 5\nf 1 2 3 4\n");
  ASSERT_EQ(run_quarry({"picture", mesh, "-o", folder / "a.svg", "--window", "2", "3", "9", "9"}).exit_code,
            0);
  for (const std::string word : {"(30, 30)", "(1, 2) to (3, 5)"})
    expect_failure({"picture", mesh, "-o", folder / "b.svg", "--window", "30", "30", "40", "40"}, 2, word);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj", "a.svg"}));
}

TEST(Outputs, CompressionKeepsTheMesh) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "raw.vtu", "--size", "10"}).exit_code, 0);
  ASSERT_EQ(
      run_quarry({"mesh", kDemoSection, "-o", folder / "zip.vtu", "--size", "10", "--compress"}).exit_code,
      0);
  EXPECT_LT(std::filesystem::file_size(folder / "zip.vtu"), std::filesystem::file_size(folder / "raw.vtu"));
  EXPECT_EQ(run_quarry({"quality", folder / "zip.vtu", "--json"}).out,
            run_quarry({"quality", folder / "raw.vtu", "--json"}).out);
}

TEST(Outputs, ABrokenMeshIsToldWithItsFile) {
  const TestFolder folder;
  expect_failure({"quality", folder.write("broken.vtu", "<VTKFile>")}, 3, "broken.vtu");
  expect_failure({"quality", folder / "none.msh"}, 3, "none.msh");
  expect_failure({"convert", folder.write("broken.obj", "f 1 2 9\n"), folder / "out.vtu"}, 3, "broken.obj");
}

TEST(Outputs, OfASurfaceThatCannotBeMeshedAreTheReportAndTheRepairedSurface) {
  const TestFolder folder;
  const std::string flat = folder.write("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 5 5 5\nf 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(run_quarry({"mesh", flat, "-o", folder / "out.vtu", "--count", "9", "--report",
                        folder / "report.json", "--repaired", folder / "repaired.obj"})
                .exit_code,
            4);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"flat.obj", "repaired.obj", "report.json"}));
  const nlohmann::json report = nlohmann::json::parse(read_text(folder / "report.json"));
  EXPECT_EQ(report["counts"]["duplicate_triangles"], 1);
  EXPECT_NE(report["notes"].dump().find("no mesh was made: the surface has no area"), std::string::npos);
}

// Two squares that share a corner, and a hole that meets the rim of its square in one point.
constexpr const char* kTouching =
    R"({"type": "MultiPolygon", "coordinates": [[[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]],
        [[5, 0], [7, 4], [3, 4], [5, 0]]], [[[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]]]})";

TEST(Outputs, APointWhereTheDomainTouchesItselfIsOnePoint) {
  const TestFolder folder;
  const std::string input = folder.write("touching.geojson", kTouching);
  ASSERT_EQ(run_quarry({"mesh", input, "-o", folder / "out.vtu", "--size", "1"}).exit_code, 0);
  for (const std::string name : {"out.msh", "out.obj"}) {
    ASSERT_EQ(run_quarry({"mesh", input, "-o", folder / name, "--size", "1"}).exit_code, 0) << name;
    EXPECT_EQ(quality_of(folder / name)["vertices"], quality_of(folder / "out.vtu")["vertices"]) << name;
  }
  const nlohmann::json quality = quality_of(folder / "out.vtu");
  EXPECT_NEAR(quality["area"].get<double>(), 192, 1e-9);
  ASSERT_EQ(run_quarry({"convert", folder / "out.vtu", folder / "again.vtu"}).exit_code, 0);
  EXPECT_EQ(quality_of(folder / "again.vtu")["vertices"], quality["vertices"]);
}

// Signals arrive while the job works: after it has told what is to be expected.
class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, EndsTheJobAndLeavesNothing) {
  const TestFolder folder;
  const std::string output = folder.write("out.vtu", "what was there before");
  CommandOptions options;
  options.signal = [](const std::string& err) {
    return err.find("to be expected") == std::string::npos ? 0 : GetParam();
  };
  const CommandResult result = run_quarry(
      {"mesh", kDemoSection, "-o", output, "--size", "0.4", "--report", folder / "r.json"}, options);
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
  EXPECT_EQ(result.error_lines(), 2U) << result.err;
  EXPECT_EQ(read_text(output), "what was there before");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.vtu"});
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](const testing::TestParamInfo<int>& signal) {
                           return signal.param == SIGINT ? "SIGINT" : "SIGTERM";
                         });

}  // namespace
}  // namespace quarry
