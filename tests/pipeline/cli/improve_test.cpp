// `quarry improve` from file to file.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/geometry/segment.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

class ImproveCommand : public testing::Test {
 protected:
  // Quads of the demo section, not cleaned up.
  [[nodiscard]] std::string mesh(const std::string& name = "in.vtu") const {
    const CommandResult made = run_quarry(
        {"mesh", kDemoSection, "-o", folder_ / name, "--size", "12", "--cleanup", "none", "--quiet"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return folder_ / name;
  }
  void expect_failure(const std::vector<std::string>& arguments, int code, const std::string& word) const {
    std::vector<std::string> words = {"improve"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const CommandResult result = run_quarry(words);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.error_lines(), 1U) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
  }
  TestFolder folder_;
};

TEST_F(ImproveCommand, TellsTheQualityBeforeAndAfter) {
  const std::string report = folder_ / "r.json";
  const CommandResult result = run_quarry(
      {"improve", mesh(), "-o", folder_ / "out.vtu", "--report", report, "--picture", folder_ / "out.svg"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  for (const char* word : {"before: quality", "after: quality", "wrote"})
    EXPECT_NE(result.err.find(word), std::string::npos) << word;
  const nlohmann::json json = nlohmann::json::parse(read_text(report));
  EXPECT_EQ(json["command"], "improve");
  EXPECT_EQ(json["options"]["cleanup"], "full");
  EXPECT_LT(json["quality"]["valence"]["irregular_share"],
            json["quality_before"]["valence"]["irregular_share"]);
  EXPECT_GT(json["quality"]["scaled_jacobian"]["mean"], json["quality_before"]["scaled_jacobian"]["mean"]);
  EXPECT_NEAR(json["quality"]["area"].get<double>(), json["quality_before"]["area"].get<double>(), 1e-3);
  EXPECT_TRUE(json.contains("cleanup"));
  EXPECT_NE(read_text(folder_ / "out.svg").find("<svg"), std::string::npos);
}

using Segments = std::vector<std::pair<Vec2, Vec2>>;

// The edges of each line, by its number; those of the boundary without a line are under -1.
std::map<std::int32_t, Segments> lines_of(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  const MeshFileTags tags(mesh);
  std::map<std::int32_t, Segments> lines;
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    lines[tags.constraint(e)].emplace_back(mesh.point(a), mesh.point(b));
  }
  return lines;
}

// Whether all ends and middles of the ones lie on the others.
bool lie_on(const Segments& ones, const Segments& others) {
  constexpr double kNear = 1e-6;
  const auto covered = [&](Vec2 p) {
    return std::any_of(others.begin(), others.end(), [&](const auto& segment) {
      return squared_distance(p, segment.first, segment.second) < kNear * kNear;
    });
  };
  return std::all_of(ones.begin(), ones.end(), [&](const auto& segment) {
    return covered(segment.first) && covered(segment.second) &&
           covered(midpoint(segment.first, segment.second));
  });
}

// Networks with crossings, junctions and dead ends, in each format that carries lines.
TEST_F(ImproveCommand, KeepsEveryLineOfDrawnNetworksInItsPlace) {
  int seed = 0;
  for (const std::string format : {".vtu", ".msh", ".obj", ".inp", ".vtu", ".msh"}) {
    SCOPED_TRACE(testing::Message() << "seed " << ++seed << ", " << format);
    const std::string network = folder_ / "network.geojson", in = folder_ / ("net" + format),
                      out = folder_ / ("better" + format);
    ASSERT_EQ(run_quarry({"generate", "fractures", "--count", "25", "--seed", std::to_string(seed), "-o",
                          network, "-q"})
                  .exit_code,
              0);
    ASSERT_EQ(run_quarry({"mesh", network, "-o", in, "--size", "30", "--cleanup", "none", "-q"}).exit_code,
              0);
    ASSERT_EQ(run_quarry({"improve", in, "-o", out, "-q"}).exit_code, 0);
    const auto before = lines_of(in), after = lines_of(out);
    ASSERT_GT(before.size(), 10U);
    ASSERT_EQ(after.size(), before.size());
    for (const auto& [number, edges] : before) {
      ASSERT_TRUE(after.contains(number));
      EXPECT_TRUE(lie_on(after.at(number), edges)) << "line " << number;
      EXPECT_TRUE(lie_on(edges, after.at(number))) << "line " << number;
    }
  }
}

TEST_F(ImproveCommand, WithoutCleanUpKeepsTheTopology) {
  const std::string report = folder_ / "r.json";
  ASSERT_EQ(run_quarry({"improve", mesh(), "-o", folder_ / "out.msh", "--cleanup", "none", "--size", "12",
                        "--report", report})
                .exit_code,
            0);
  const nlohmann::json json = nlohmann::json::parse(read_text(report));
  EXPECT_EQ(json["quality"]["valence"], json["quality_before"]["valence"]);
  EXPECT_FALSE(json.contains("cleanup"));
}

TEST_F(ImproveCommand, CutsLowQuadsIfAskedTo) {
  const std::string report = folder_ / "r.json";
  ASSERT_EQ(run_quarry({"improve", mesh(), "-o", folder_ / "out.msh", "--elements", "mixed",
                        "--mixed-quality", "0.6", "--report", report})
                .exit_code,
            0);
  const nlohmann::json json = nlohmann::json::parse(read_text(report));
  EXPECT_EQ(json["options"]["mixed-quality"], 0.6);
  EXPECT_EQ(json["quality_before"]["triangles"], 0);
  EXPECT_GT(json["counts"]["quads_cut"], 0);
  EXPECT_EQ(json["quality"]["triangles"], 2 * json["counts"]["quads_cut"].get<int>());
}

TEST_F(ImproveCommand, WritesTheSameBytesOnAnyNumberOfThreads) {
  const std::string input = mesh();
  std::string one;
  for (const std::string threads : {"1", "2", "4", "7"}) {
    ASSERT_EQ(run_quarry({"improve", input, "-o", folder_ / "out.vtu", "--threads", threads, "-q"}).exit_code,
              0);
    if (one.empty()) one = read_text(folder_ / "out.vtu");
    EXPECT_TRUE(read_text(folder_ / "out.vtu") == one) << threads << " threads";
  }
}

TEST_F(ImproveCommand, ConfigFilesGiveItsOptions) {
  const std::string config =
      folder_.write("job.toml", "inputs = \"" + mesh() + "\"\ncleanup = \"local\"\nquiet = true\n");
  const CommandResult result =
      run_quarry({"improve", "-o", folder_ / "out.vtu", "--config", config, "--report", folder_ / "r.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(read_text(folder_ / "r.json"))["options"]["cleanup"], "local");
}

TEST_F(ImproveCommand, RefusesInOneLine) {
  const std::string input = mesh();
  const std::string output = folder_ / "out.vtu";
  expect_failure({}, 2, "no mesh");
  expect_failure({input}, 2, "output");
  expect_failure({input, "-o", folder_ / "out.xyz"}, 2, "out.xyz");
  expect_failure({folder_ / "in.xyz", "-o", output}, 2, "in.xyz");
  expect_failure({input, "-o", input}, 2, "in.vtu");
  expect_failure({input, "-o", output, "--cleanup", "most"}, 2, "most");
  expect_failure({input, "-o", output, "--size", "-1"}, 2, "--size");
  expect_failure({input, "-o", output, "--mixed-quality", "0.4"}, 2, "--elements mixed");
  expect_failure({input, "-o", output, "--tolerance", "nan"}, 2, "--tolerance");
  expect_failure({folder_ / "none.msh", "-o", output}, 3, "none.msh");
  expect_failure({folder_.write("broken.inp", "*NODE\n1, x\n"), "-o", output}, 3, "broken.inp:2: ");
  const std::string space = folder_.write("space.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n");
  expect_failure({space, "-o", output, "--size", "1"}, 2, "--size is for meshes of the plane");
  expect_failure({input, "-o", output, "--sharp", "0"}, 2, "--sharp");
  expect_failure({input, "-o", output, "--require", "min-sj=0.9999", "--quiet"}, 6, "min-sj");
  expect_failure({input, "-o", folder_ / "no/folder/out.vtu"}, 7, "out.vtu");
  EXPECT_EQ(read_text(output), "");
}

}  // namespace
}  // namespace quarry
