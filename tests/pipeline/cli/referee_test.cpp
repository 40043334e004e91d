// The independent referee on what the command writes for real maps: valid, conforming, complete, every line
// honoured.
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

constexpr const char* kReferee = "../shared/referee/section.py";

struct Job {
  const char* name;
  std::string lines;
  std::string boundary;
  double size = 0;  // 0: a 150th of the longer side
};

void PrintTo(const Job& job, std::ostream* stream) { *stream << job.name; }

std::string output_of(const std::string& command) {
  std::string text;
  if (FILE* pipe = ::popen(command.c_str(), "r")) {
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
      text.append(part.data(), count);
    ::pclose(pipe);
  }
  return text;
}

// The longer side of the box of all coordinates in a GeoJSON file.
double longer_side(const std::string& path) {
  std::array<double, 2> low = {1e300, 1e300};
  std::array<double, 2> high = {-1e300, -1e300};
  const std::function<void(const nlohmann::json&)> visit = [&](const nlohmann::json& node) {
    if (node.is_array() && node.size() >= 2 && node[0].is_number()) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], node[axis].get<double>());
        high[axis] = std::max(high[axis], node[axis].get<double>());
      }
    } else if (node.is_structured()) {
      for (const nlohmann::json& child : node) visit(child);
    }
  };
  visit(nlohmann::json::parse(read_text(path))["features"]);
  return std::max(high[0] - low[0], high[1] - low[1]);
}

class SectionReferee : public testing::TestWithParam<Job> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kReferee)) GTEST_SKIP() << kReferee << " is not there";
    if (!std::filesystem::exists(GetParam().lines)) GTEST_SKIP() << GetParam().lines << " is not there";
    if (output_of("/usr/bin/python3 -c 'import numpy, scipy; print(1)' 2>/dev/null") != "1\n")
      GTEST_SKIP() << "python3-numpy and python3-scipy are not installed";
  }
};

TEST_P(SectionReferee, FindsNothingWrong) {
  const Job& job = GetParam();
  const TestFolder folder;
  const double size = job.size > 0 ? job.size : longer_side(job.lines) / 150;
  std::vector<std::string> arguments = {
      "mesh",     job.lines,        "-o", folder / "out.vtu", "--size", fmt::format("{}", size),
      "--report", folder / "r.json"};
  if (!job.boundary.empty()) arguments.insert(arguments.end(), {"--boundary", job.boundary});
  const CommandResult result = run_quarry(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string verdict = output_of(
      fmt::format("/usr/bin/python3 -B {} {} --lines {} --near {} --report {} --all-quad --max-aspect 12",
                  kReferee, folder / "out.vtu", job.lines, (0.05 + 0.1 + 0.05) * size, folder / "r.json"));
  const nlohmann::json json = nlohmann::json::parse(verdict);
  EXPECT_TRUE(json["failed"].empty()) << verdict;
}

std::string planar(const std::string& name) { return "../shared/data/planar/" + name + ".lines.geojson"; }

INSTANTIATE_TEST_SUITE_P(Maps, SectionReferee,
                         testing::Values(Job{"Demo", kDemoSection, "", 6},
                                         Job{"Kb11", planar("kb11_traces"), planar("kb11_area")},
                                         Job{"Hastholmen", planar("hastholmen_traces"), ""},
                                         Job{"Lineaments", planar("lineaments_200k"), ""},
                                         Job{"SectionModel", planar("section_model_a1_x2500"), ""}),
                         [](const testing::TestParamInfo<Job>& job) { return std::string(job.param.name); });

}  // namespace
}  // namespace quarry
