// What a job tells about itself, as plain data that the job fills in, and its JSON form (docs/contract.md,
// "The report"). Two runs with the same input and options differ in times, memory and thread counts only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/operation/pass.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/report/region_summary.hpp"
#include "pipeline/report/stages.hpp"

namespace quarry {

using ReportValue = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>>;

// A name and a value, written in the order of the list.
struct ReportItem {
  std::string name;
  ReportValue value;
};

struct JobReport {
  std::string command;
  std::string version;
  std::vector<ReportItem> options;  // resolved: with the defaults that were filled in
  int threads = 1;

  std::vector<std::string> input_files;
  std::string input_hash;
  // What the files say of their coordinates, one a file; empty where no file says anything.
  std::vector<std::string> coordinate_systems;
  std::string outline;  // which rule gave the outline, in words
  // What became of each input line; its index is the line's number.
  IdVector<LineId, LedgerEntry> lines;
  // What became of each input point, and what the input says of it.
  IdVector<PointId, PointEntry> points;
  IdVector<PointId, LineAttributes> point_attributes;
  // What the input says of each line, and its file (an index into input_files); empty where that is nothing,
  // and where there is one file.
  IdVector<LineId, LineAttributes> line_attributes;
  IdVector<LineId, std::uint32_t> line_files;
  // Largest distance between each line and its mesh edges; NaN for a line without any.
  IdVector<LineId, double> line_distances;

  std::vector<ReportItem> counts;
  std::vector<RegionSummary> regions;
  QualitySummary quality;
  std::optional<QualitySummary> quality_before;  // of the input, where that is a mesh
  std::vector<PassReport> passes;                // beside those of the clean-up
  std::optional<CleanUpReport> clean_up;         // of jobs that clean up
  std::vector<StageTime> times;                  // of the stages, in order
  std::vector<std::string> notes;                // one line each: what the user should know
};

// The whole report as JSON text. Reads the peak memory of the process.
[[nodiscard]] std::string report_text(const JobReport& report);

// Writes it as a file. Throws Error(kOutput).
void write_report(const std::string& path, const JobReport& report);

// The "quality" part alone: what `quarry quality --json` prints.
[[nodiscard]] std::string quality_text(const QualitySummary& quality);

// Largest resident memory of this process so far.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace quarry
