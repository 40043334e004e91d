#include "pipeline/report/clean_up_json.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quarry {
namespace {

using Json = nlohmann::ordered_json;

LocalOperatorReport operator_report() {
  LocalOperatorReport report;
  report.pass = {"edge rotation", 3, 100, 40, 30};
  report.won = 21;
  report.invalid = 4;
  report.poor = 5;
  report.seconds = 0.25;
  return report;
}

// Of each kind of fill and each reason another number.
PatchReport patch_report(std::uint64_t largest, bool over_lines) {
  PatchReport report;
  report.largest = largest;
  report.over_lines = over_lines;
  report.commits = {"", 7, 60, 50, 45};
  for (std::size_t i = 0; i < kFillKinds; ++i) {
    report.proposed[i] = 10 + i;
    report.won[i] = i;
  }
  for (std::size_t i = 0; i < kPatchRejects; ++i) report.rejected[i] = 100 + i;
  report.search_seconds = 0.5;
  report.commit_seconds = 0.75;
  return report;
}

ChordReport chord_report() {
  ChordReport report;
  report.rounds = 3;
  report.chords = 40;
  report.collapsible = 30;
  report.tried = 5;
  report.won = 4;
  report.gained = 8;
  report.commits = {"", 2, 6, 5, 5};
  for (std::size_t i = 0; i < kChordRejects; ++i) report.rejected[i] = 200 + i;
  return report;
}

CleanUpReport clean_up_report() {
  CleanUpReport report;
  report.local.operators.push_back(operator_report());
  report.local.irregular_before = 900;
  report.local.irregular_after = 300;
  report.patches = {patch_report(32, false), patch_report(128, true)};
  report.chords = chord_report();
  report.local_at_end.operators.push_back(operator_report());
  report.local_at_end.operators.back().won = 2;
  return report;
}

TEST(CleanUpJson, SaysOfEachOperatorWhatWasTriedWonAndRejected) {
  const Json json = clean_up_json(clean_up_report());
  EXPECT_EQ(json["irregular_before"], 900);
  EXPECT_EQ(json["irregular_after_operators"], 300);
  const Json& rotation = json["operators"][0];
  EXPECT_EQ(rotation["name"], "edge rotation");
  EXPECT_EQ(rotation["looked_at"], 100);
  EXPECT_EQ(rotation["tried"], 30);
  EXPECT_EQ(rotation["won"], 21);
  EXPECT_EQ(rotation["rejected"], Json({{"no_gain", 60}, {"overlap", 10}, {"invalid", 4}, {"quality", 5}}));
  EXPECT_EQ(json["operators_at_end"][0]["won"], 2);
}

TEST(CleanUpJson, SaysOfEachSizeClassWhatWasTriedWonAndRejected) {
  const Json json = clean_up_json(clean_up_report());
  ASSERT_EQ(json["patches"].size(), 2U);
  const Json& patches = json["patches"][1];
  EXPECT_EQ(patches["largest"], 128);
  EXPECT_EQ(patches["over_lines"], true);
  EXPECT_EQ(patches["tried"]["three_sided"], 10);
  EXPECT_EQ(patches["tried"]["six_sided"], 14);
  EXPECT_EQ(patches["won"]["grid"], 1);
  const auto reason = [](PatchReject reject) { return 100 + static_cast<int>(reject); };
  EXPECT_EQ(patches["rejected"]["no_disk"], reason(PatchReject::kNoDisk));
  EXPECT_EQ(patches["rejected"]["no_solution_5"], reason(PatchReject::kNoSolution5));
  EXPECT_EQ(patches["rejected"]["number_of_faces"], reason(PatchReject::kFaceBand));
  EXPECT_EQ(patches["rejected"]["no_gain"], reason(PatchReject::kNoGain));
  EXPECT_EQ(patches["rejected"]["lines"], reason(PatchReject::kLines));
  EXPECT_EQ(patches["rejected"]["double_edge"], reason(PatchReject::kDoubleEdge));
  EXPECT_EQ(patches["rejected"]["quality"], reason(PatchReject::kQuality));
}

TEST(CleanUpJson, SaysOfChordsWhatWasTriedWonAndRejected) {
  const Json json = clean_up_json(clean_up_report());
  const Json& chords = json["chords"];
  EXPECT_EQ(chords["chords"], 40);
  EXPECT_EQ(chords["collapsible"], 30);
  EXPECT_EQ(chords["tried"], 5);
  EXPECT_EQ(chords["won"], 4);
  EXPECT_EQ(chords["energy"], 8);
  const auto reason = [](ChordReject reject) { return 200 + static_cast<int>(reject); };
  EXPECT_EQ(chords["rejected"]["long"], reason(ChordReject::kLong));
  EXPECT_EQ(chords["rejected"]["lines"], reason(ChordReject::kLines));
  EXPECT_EQ(chords["rejected"]["not_whole"], reason(ChordReject::kNotWhole));
  EXPECT_EQ(chords["rejected"]["few_faces"], reason(ChordReject::kFewFaces));
  EXPECT_EQ(chords["rejected"]["no_gain"], reason(ChordReject::kNoGain));
  EXPECT_EQ(chords["rejected"]["overlap"], reason(ChordReject::kOverlap));
  EXPECT_EQ(chords["rejected"]["number_of_faces"], reason(ChordReject::kFaceBand));
  EXPECT_EQ(chords["rejected"]["quality"], reason(ChordReject::kQuality));
}

TEST(CleanUpJson, HasTheSecondsOfEachOperatorAndSizeClass) {
  const Json json = clean_up_times_json(clean_up_report());
  EXPECT_EQ(json["edge rotation"], 0.25);
  EXPECT_EQ(json["edge rotation at the end"], 0.25);
  EXPECT_EQ(json["patches of 32"]["search"], 0.5);
  EXPECT_EQ(json["patches of 128 over lines"]["commit"], 0.75);
}

TEST(CleanUpJson, NamesThePassesApart) {
  const std::vector<PassReport> passes = passes_of(clean_up_report());
  ASSERT_EQ(passes.size(), 5U);
  EXPECT_EQ(passes[0].name, "edge rotation");
  EXPECT_EQ(passes[1].name, "patches of 32");
  EXPECT_EQ(passes[2].name, "chords");
  EXPECT_EQ(passes[2].rounds, 2U);
  EXPECT_EQ(passes[3].name, "patches of 128 over lines");
  EXPECT_EQ(passes[3].rounds, 7U);
  EXPECT_EQ(passes[4].name, "edge rotation at the end");
}

}  // namespace
}  // namespace quarry
