#include "pipeline/report/job_report.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "pipeline/report/line_distance.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

JobReport sample_report() {
  const Mesh mesh = make_sample_mesh({.size = 12});
  JobReport report;
  report.command = "mesh";
  report.version = "0.1.0";
  report.options = {{"size", 0.5}, {"elements", std::string("quad")}, {"keep_boundary", false}};
  report.counts = {{"vertices", std::int64_t{169}}};
  report.threads = 3;
  report.input_files = {"a.geojson"};
  report.lines = IdVector<LineId, LedgerEntry>(2);
  report.lines[LineId(std::size_t{1})] = {
      LineFate::kDropped, {LineId(std::size_t{0})}, "shorter than min-edge", 0.25, {}, 0};
  report.line_distances = IdVector<LineId, double>(2, std::numeric_limits<double>::quiet_NaN());
  report.line_distances[LineId(std::size_t{0})] = 0.125;
  report.regions = summarize_regions(mesh);
  report.quality = summarize_quality(mesh);
  report.passes = {{"insert", 7, 100, 90, 80}};
  report.times = {{"cleaning", 0.5, 0.5}, {"insertion", 1.5, 3.6}};
  return report;
}

TEST(JobReport, HoldsWhatTheContractLists) {
  const auto json = nlohmann::json::parse(report_text(sample_report()));
  EXPECT_EQ(json["options"]["elements"], "quad");
  EXPECT_EQ(json["options"]["keep_boundary"], false);
  EXPECT_EQ(json["counts"]["vertices"], 169);
  EXPECT_EQ(json["threads"], 3);
  EXPECT_DOUBLE_EQ(json["times"]["total"], 2.0);
  EXPECT_GT(json["peak_memory_bytes"], 1000000);
  EXPECT_EQ(json["passes"][0]["won"], 80);
  const auto& quality = json["quality"];
  for (const char* key : {"min", "mean", "share_below_0.2", "share_not_positive"})
    EXPECT_TRUE(quality["scaled_jacobian"].contains(key)) << key;
  EXPECT_EQ(quality["min_angle"]["histogram_10_degrees"].size(), 9U);
  EXPECT_EQ(quality["lo_measure"]["histogram_0.1"].size(), 10U);
  EXPECT_TRUE(quality["valence"].contains("irregular_share"));
  EXPECT_TRUE(quality["valence"]["histogram"].contains("4"));
}

TEST(JobReport, TellsHowLongThreadsWereWithoutWorkInEachStage) {
  const auto json = nlohmann::json::parse(report_text(sample_report()))["processor"];
  EXPECT_DOUBLE_EQ(json["cleaning"]["seconds"], 0.5);
  EXPECT_DOUBLE_EQ(json["cleaning"]["idle"], 1 - 1.0 / 3);
  EXPECT_DOUBLE_EQ(json["insertion"]["busy"], 0.8);
  EXPECT_DOUBLE_EQ(json["total"]["busy"], 4.1 / 6);
}

TEST(JobReport, ListsThePassesOfTheCleanUpWithTheOthers) {
  JobReport report = sample_report();
  report.clean_up.emplace();
  LocalOperatorReport& local = report.clean_up->local.operators.emplace_back();
  local.pass = {"face collapse", 3, 30, 20, 10};
  PatchReport& patches = report.clean_up->patches.emplace_back();
  patches.largest = 32;
  patches.commits = {"", 2, 8, 7, 6};
  PatchReport over_lines = patches;
  over_lines.largest = 128;
  over_lines.over_lines = true;
  report.clean_up->patches.push_back(over_lines);
  const auto passes = nlohmann::json::parse(report_text(report))["passes"];
  ASSERT_EQ(passes.size(), 4U);
  EXPECT_EQ(passes[1]["name"], "face collapse");
  EXPECT_EQ(passes[1]["rounds"], 3);
  EXPECT_EQ(passes[2]["name"], "patches of 32");
  EXPECT_EQ(passes[2]["live"], 7);
  EXPECT_EQ(passes[3]["name"], "patches of 128 over lines");
}

TEST(JobReport, TellsTheFateOfEachLine) {
  const auto json = nlohmann::json::parse(report_text(sample_report()));
  const auto& lines = json["input"]["lines"];
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["fate"], "kept");
  EXPECT_EQ(lines[1]["line"], 1);
  EXPECT_EQ(lines[1]["fate"], "dropped");
  EXPECT_EQ(lines[1]["with"], nlohmann::json::array({0}));
  EXPECT_EQ(lines[1]["why"], "shorter than min-edge");
  EXPECT_DOUBLE_EQ(lines[1]["moved"], 0.25);
}

TEST(JobReport, ListsDistancesOfTheLinesThatHaveEdges) {
  const auto json = nlohmann::json::parse(report_text(sample_report()));
  ASSERT_EQ(json["constraints"]["lines"].size(), 1U);
  EXPECT_DOUBLE_EQ(json["constraints"]["largest_distance"], 0.125);
}

TEST(JobReport, TakesFileNamesThatAreNoUtf8) {
  JobReport report = sample_report();
  report.input_files = {"caf\xe9.geojson"};
  EXPECT_EQ(nlohmann::json::parse(report_text(report))["input"]["files"].size(), 1U);
}

TEST(JobReport, IsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  write_report(folder.file("report.json"), sample_report());
  EXPECT_EQ(nlohmann::json::parse(file_content(folder.file("report.json")))["command"], "mesh");
  EXPECT_THROW(write_report(folder.file("absent/report.json"), sample_report()), Error);
}

TEST(RegionSummary, CountsFacesAndAreas) {
  const auto regions = summarize_regions(make_sample_mesh({.size = 4, .disorder = 0, .triangles = false}));
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[1].region, 1);
  EXPECT_EQ(regions[1].faces, 8U);
  EXPECT_DOUBLE_EQ(regions[1].area, 8.0);
}

// A mesh whose edges of line 3 run along x = 2, from y = 0 to 4.
class LineDistance : public testing::Test {
 protected:
  LineDistance() { lines_.lines.resize(6); }
  double measured(std::vector<Vec2> points, const IdVector<LineId, LedgerEntry>& ledger = {}) {
    const Mesh mesh = make_sample_mesh({.size = size_, .disorder = 0, .triangles = false});
    lines_.lines[LineId(std::size_t{3})].points = std::move(points);
    return measure_line_distances(mesh, lines_, ledger)[LineId(std::size_t{3})];
  }
  std::uint32_t size_ = 4;
  LineSet lines_;
};

TEST_F(LineDistance, IsZeroForALineThatIsKept) { EXPECT_EQ(measured({{2, 0}, {2, 1.5}, {2, 4}}), 0.0); }

TEST_F(LineDistance, IsMeasuredFromTheEdgesToTheLine) { EXPECT_EQ(measured({{2, 0.75}, {2, 4}}), 0.75); }

TEST_F(LineDistance, IsMeasuredFromTheLineToTheEdges) {
  EXPECT_EQ(measured({{2, 0}, {2.25, 1}, {2, 4}, {2, 6}}), 2.0);
}

TEST_F(LineDistance, LeavesOutWhatWasClipped) {
  IdVector<LineId, LedgerEntry> ledger(6);
  ledger[LineId(std::size_t{3})].clipped_length = 2;
  EXPECT_EQ(measured({{2, 0}, {2, 4}, {2, 6}}, ledger), 0.0);
}

TEST_F(LineDistance, FindsTheNearestOfManySegments) {
  size_ = 100;
  std::vector<Vec2> zigzag;
  for (int i = 0; i <= 1000; ++i) zigzag.push_back({50 + (i % 2 == 0 ? 0.0 : 0.0625), 0.1 * i});
  zigzag[501].x = 57;
  EXPECT_DOUBLE_EQ(measured(zigzag), 7.0);
}

TEST_F(LineDistance, IsNotANumberForALineWithoutEdges) {
  lines_.lines[LineId(std::size_t{2})].points = {{0, 0}, {1, 1}};
  const Mesh mesh = make_sample_mesh({.size = 4});
  EXPECT_TRUE(std::isnan(measure_line_distances(mesh, lines_, {})[LineId(std::size_t{2})]));
}

}  // namespace
}  // namespace quarry
