// `quarry batch`, with itself as the worker.
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

constexpr const char* kSquare =
    R"({"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]})";
constexpr const char* kPoints = "0 0 10 0 10 10\n1 2 8 7 9 9\n";

nlohmann::json jobs_of(const std::string& folder) {
  return nlohmann::json::parse(read_text(folder + "/batch/table.json"))["jobs"];
}

class BatchCommand : public testing::Test {
 protected:
  BatchCommand() { std::filesystem::create_directory(folder_ / "in"); }
  [[nodiscard]] CommandResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "batch");
    arguments.insert(arguments.end(), {"-o", folder_ / "out"});
    return run_quarry(arguments);
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::filesystem::exists(folder_ / ("out/" + name));
  }

  TestFolder folder_;
};

TEST_F(BatchCommand, MeshesWhatLiesInAFolderAsMeshDoes) {
  const std::string square = folder_.write("in/square.geojson", kSquare);
  (void)folder_.write("in/empty.wkt", "");
  (void)folder_.write("in/notes.txt", "nothing of that kind");
  (void)folder_.write("in/notes.pdf", "nothing of that kind");
  (void)folder_.write("in/.hidden.geojson", kSquare);
  const CommandResult result = run({folder_ / "in", "--size", "2"});
  EXPECT_EQ(result.exit_code, 8) << result.err;
  EXPECT_NE(result.err.find("notes.pdf, notes.txt"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("\nempty   failed "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\nsquare  done "), std::string::npos) << result.out;
  EXPECT_EQ(jobs_of(folder_ / "out").size(), 2U);
  EXPECT_EQ(jobs_of(folder_ / "out")[0]["exit_code"], 3);
  ASSERT_EQ(run_quarry({"mesh", square, "-o", folder_ / "alone.vtu", "--size", "2"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "out/square.vtu"), read_text(folder_ / "alone.vtu"));
  EXPECT_TRUE(has("square.json"));
  EXPECT_FALSE(has("empty.vtu"));
}

TEST_F(BatchCommand, PassesOverWhatIsDoneUntilItsInputOrItsOptionsChange) {
  (void)folder_.write("in/a.geojson", kSquare);
  (void)folder_.write("in/b.geojson", kSquare);
  const auto outcomes = [&](const std::string& size) {
    EXPECT_EQ(run({folder_ / "in", "--size", size}).exit_code, 0);
    const nlohmann::json jobs = jobs_of(folder_ / "out");
    return jobs[0]["outcome"].get<std::string>() + " " + jobs[1]["outcome"].get<std::string>();
  };
  EXPECT_EQ(outcomes("2"), "done done");
  EXPECT_EQ(outcomes("2"), "skipped skipped");
  (void)folder_.write("in/b.geojson", std::string(kSquare) + "\n");
  EXPECT_EQ(outcomes("2"), "skipped done");
  EXPECT_EQ(outcomes("1"), "done done");
}

TEST_F(BatchCommand, TakesJobsFromAListWithDefaults) {
  const std::string square = folder_.write("square.geojson", kSquare);
  const std::string list =
      folder_.write("jobs.toml", "[defaults]\nsize = 2\nelements = \"tri\"\n[[job]]\ninput = \"" + square +
                                     "\"\n[[job]]\nname = \"quads\"\ninput = [\"" + square +
                                     "\"]\ncount = 60\nelements = \"quad\"\n" +
                                     "output = \"sub/quads.msh\"\npicture = \"sub/quads.svg\"\n");
  const CommandResult result = run({list});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has("square.vtu") && has("sub/quads.msh") && has("sub/quads.svg") && has("quads.json"));
  const auto report = [&](const std::string& name) {
    return nlohmann::json::parse(read_text(folder_ / ("out/" + name + ".json")));
  };
  EXPECT_EQ(report("square")["options"]["elements"], "tri");
  EXPECT_EQ(report("square")["options"]["size"], 2.0);
  EXPECT_EQ(report("quads")["options"]["elements"], "quad");
  EXPECT_EQ(report("quads")["counts"]["triangles"], 0);
  // The command line has the last word.
  EXPECT_EQ(run({list, "--size", "1"}).exit_code, 0);
  EXPECT_EQ(report("square")["options"]["size"], 1.0);
  EXPECT_EQ(report("quads")["options"]["size"], 1.0);
}

TEST_F(BatchCommand, NamesJobsApart) {
  std::filesystem::create_directory(folder_ / "other");
  for (const char* name : {"in/a.geojson", "in/b.geojson", "other/b.geojson"})
    (void)folder_.write(name, kSquare);
  (void)folder_.write("in/a.txt", kPoints);
  (void)run({folder_ / "in", folder_ / "other", "--size", "2"});
  std::vector<std::string> names;
  for (const auto& job : jobs_of(folder_ / "out")) names.push_back(job["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"a.geojson", "a.txt", "in_b.geojson", "other_b.geojson"}));
}

TEST_F(BatchCommand, RefusesListsThatMakeNoSense) {
  const std::string square = folder_.write("square.geojson", kSquare);
  const std::string job = "[[job]]\ninput = \"" + square + "\"\n";
  const auto refuses = [&](const std::string& text, int code, const std::string& word) {
    const CommandResult result = run({folder_.write("jobs.toml", text)});
    EXPECT_EQ(result.exit_code, code) << text;
    EXPECT_NE(result.err.find(word), std::string::npos) << text << result.err;
    EXPECT_EQ(result.error_lines(), 1U) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << text;
  };
  refuses("", 2, "no table [[job]]");
  refuses("[[job]", 3, "line 1");
  refuses("job = 3", 2, "line 1: key job");
  refuses("job = []", 2, "line 1: key job");
  refuses("job = [1, {}]", 2, "line 1: key job");
  refuses("[[job]]\nsize = 3\n", 2, "no input");
  refuses("[[job]]\ninput = \"\"\n", 2, "line 2: key input");
  refuses("[[job]]\ninput = \"-\"\n", 2, "standard input");
  refuses(job + "sise = 3\n", 2, "line 3: key sise");
  refuses(job + "threads = 3\n", 2, "line 3: key threads");
  refuses(job + "elements = \"hex\"\n", 2, "line 3: key elements");
  refuses(job + "name = \"a/b\"\n", 2, "line 3: key name");
  refuses("[defaults]\nname = \"a\"\n" + job, 2, "line 2: key name");
  refuses("color = 1\n" + job, 2, "line 1: key color");
  refuses(job + job, 2, "give them names");
  refuses(job + "name = \"a\"\n" + job + "name = \"a\"\n", 2, "called a");
  refuses(job + "output = \"x.vtu\"\n" + job + "name = \"b\"\noutput = \"x.vtu\"\n", 2, "x.vtu");
  refuses(job + "output = \"" + square + "\"\n", 2, "square.geojson");
}

TEST_F(BatchCommand, RefusesFoldersThatMakeNoSense) {
  const auto code = [](const std::vector<std::string>& arguments) { return run_quarry(arguments).exit_code; };
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "out", "--size", "2"}), 3);
  (void)folder_.write("in/a.geojson", kSquare);
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "in", "--size", "2"}), 2);
  EXPECT_EQ(code({"batch", folder_ / "in", "--size", "2"}), 2);
  EXPECT_EQ(code({"batch", "-o", folder_ / "out"}), 2);
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "in/a.geojson"}), 7);
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "out", "--format", "off"}), 2);
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "out", "--job-time", "-1"}), 2);
  EXPECT_EQ(code({"batch", folder_ / "in", "-o", folder_ / "out", "--memory", "many"}), 2);
}

TEST_F(BatchCommand, EndsAJobThatGoesBeyondALimit) {
  const std::string section = read_text(kDemoSection);
  (void)folder_.write("in/section.geojson", section);
  const auto outcome = [&](const std::vector<std::string>& limit) {
    std::vector<std::string> arguments = {folder_ / "in", "--size", "0.3"};
    arguments.insert(arguments.end(), limit.begin(), limit.end());
    EXPECT_EQ(run(arguments).exit_code, 8);
    return jobs_of(folder_ / "out")[0]["outcome"].get<std::string>();
  };
  EXPECT_EQ(outcome({"--job-time", "0.2s"}), "out of time");
  EXPECT_EQ(outcome({"--job-memory", "60MB"}), "out of memory");
  EXPECT_EQ(outcome({"--memory", "60MB"}), "out of memory");
  EXPECT_FALSE(has("section.vtu"));
}

TEST_F(BatchCommand, TellsHowFarItIsWhereThereIsNoTerminal) {
  for (const char* name : {"a", "b", "c"})
    (void)folder_.write("in/" + std::string(name) + ".geojson", kSquare);
  const CommandResult often =
      run({folder_ / "in", "--size", "0.2", "--threads", "1", "--tell-every", "0.001s"});
  EXPECT_EQ(often.exit_code, 0) << often.err;
  for (const char* told : {"0/3\n", "1/3, ", "2/3, "})
    EXPECT_NE(often.err.find(told), std::string::npos) << told << " in " << often.err;
  const CommandResult rarely = run({folder_ / "in", "--size", "0.3", "--threads", "1"});
  EXPECT_EQ(rarely.err.find("1/3"), std::string::npos) << rarely.err;
  EXPECT_EQ(run({folder_ / "in", "--size", "0.2", "--tell-every", "0"}).exit_code, 2);
}

TEST_F(BatchCommand, GoesOnAfterAnInterrupt) {
  const std::string section = read_text(kDemoSection);
  for (int i = 0; i < 3; ++i) (void)folder_.write("in/s" + std::to_string(i) + ".geojson", section);
  CommandOptions interrupt;
  interrupt.signal = [&](const std::string& err) {
    return err.find("s0: done") == std::string::npos ? 0 : SIGINT;
  };
  const CommandResult result = run_quarry(
      {"batch", folder_ / "in", "-v", "--threads", "1", "--size", "4", "-o", folder_ / "out"}, interrupt);
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_NE(result.out.find("not run"), std::string::npos) << result.out;
  const CommandResult again = run({folder_ / "in", "--size", "4"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(jobs_of(folder_ / "out")[0]["outcome"], "skipped");
}

}  // namespace
}  // namespace quarry
