#include "pipeline/report/clean_up_json.hpp"

#include <array>
#include <string>

#include <nlohmann/json.hpp>

namespace quarry {
namespace {

using Json = nlohmann::ordered_json;

// In the order of FillKind and of PatchReject.
constexpr std::array<const char*, kFillKinds> kFillNames = {"three_sided", "grid", "four_sided_with_a_pair",
                                                            "five_sided", "six_sided"};
constexpr std::array<const char*, kPatchRejects> kRejectNames = {
    "no_disk",       "few_sides",       "many_sides", "no_solution_3", "no_solution_4", "no_solution_5",
    "no_solution_6", "number_of_faces", "no_gain",    "lines",         "double_edge",   "quality"};

constexpr std::array<const char*, kChordRejects> kChordRejectNames = {
    "long", "lines", "not_whole", "few_faces", "no_gain", "overlap", "number_of_faces", "quality"};

// What local operators do once more after the patches.
constexpr const char* kAtEnd = " at the end";

template <std::size_t kSize>
Json named(const std::array<const char*, kSize>& names, const std::array<std::uint64_t, kSize>& counts) {
  Json object = Json::object();
  for (std::size_t i = 0; i < kSize; ++i) object[names[i]] = counts[i];
  return object;
}

Json operator_json(const LocalOperatorReport& report) {
  const PassReport& pass = report.pass;
  return {{"name", pass.name},
          {"looked_at", pass.proposed},
          {"tried", pass.won},
          {"won", report.won},
          {"rejected",
           {{"no_gain", pass.proposed - pass.live},
            {"overlap", pass.live - pass.won},
            {"invalid", report.invalid},
            {"quality", report.poor}}}};
}

Json patches_json(const PatchReport& report) {
  return {{"largest", report.largest},
          {"over_lines", report.over_lines},
          {"seeds", report.seeds},
          {"searches", report.searches},
          {"convex_stages", report.stages},
          {"found", report.found},
          {"duplicates", report.duplicates},
          {"proposals", report.proposals},
          {"waves", report.waves},
          {"rounds", report.commits.rounds},
          {"tried", named(kFillNames, report.proposed)},
          {"won", named(kFillNames, report.won)},
          {"rejected", named(kRejectNames, report.rejected)}};
}

Json chords_json(const ChordReport& report) {
  return {{"chords", report.chords},
          {"collapsible", report.collapsible},
          {"looked_at", report.sets},
          {"rounds", report.rounds},
          {"tried", report.tried},
          {"won", report.won},
          {"faces", report.faces},
          {"energy", report.gained},
          {"rejected", named(kChordRejectNames, report.rejected)}};
}

Json operators_json(const LocalCleanupReport& report) {
  Json operators = Json::array();
  for (const LocalOperatorReport& each : report.operators) operators.push_back(operator_json(each));
  return operators;
}

std::string class_name(const PatchReport& report) {
  return "patches of " + std::to_string(report.largest) + (report.over_lines ? " over lines" : "");
}

}  // namespace

std::vector<PassReport> passes_of(const CleanUpReport& report) {
  std::vector<PassReport> passes;
  for (const LocalOperatorReport& each : report.local.operators) passes.push_back(each.pass);
  for (const PatchReport& each : report.patches) {
    passes.push_back(each.commits);
    passes.back().name = class_name(each);
    if (passes.size() != report.local.operators.size() + 1 || report.chords.rounds == 0) continue;
    passes.push_back(report.chords.commits);
    passes.back().name = "chords";
  }
  for (const LocalOperatorReport& each : report.local_at_end.operators) {
    passes.push_back(each.pass);
    passes.back().name += kAtEnd;
  }
  return passes;
}

Json clean_up_json(const CleanUpReport& report) {
  Json classes = Json::array();
  for (const PatchReport& each : report.patches) classes.push_back(patches_json(each));
  return {{"irregular_before", report.local.irregular_before},
          {"irregular_after_operators", report.local.irregular_after},
          {"operators", operators_json(report.local)},
          {"patches", std::move(classes)},
          {"chords", chords_json(report.chords)},
          {"operators_at_end", operators_json(report.local_at_end)}};
}

Json clean_up_times_json(const CleanUpReport& report) {
  Json object = {{"operators", report.local_seconds},
                 {"patches", report.patch_seconds},
                 {"chords", report.chord_seconds},
                 {"smoothing", report.smoothing_seconds}};
  for (const LocalOperatorReport& each : report.local.operators) object[each.pass.name] = each.seconds;
  for (const PatchReport& each : report.patches) {
    object[class_name(each)] = {{"search", each.search_seconds}, {"commit", each.commit_seconds}};
  }
  for (const LocalOperatorReport& each : report.local_at_end.operators)
    object[each.pass.name + kAtEnd] = each.seconds;
  return object;
}

}  // namespace quarry
