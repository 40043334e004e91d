// What a section job tells about itself: its resolved options, a hash of its input, and the report.
#pragma once

#include <string>
#include <vector>

#include "pipeline/report/job_report.hpp"
#include "pipeline/section/section.hpp"

namespace quarry {

// The options that change the mesh, with the defaults that were filled in: never threads, paths or verbosity.
[[nodiscard]] std::vector<ReportItem> resolved_options(const SectionOptions& options,
                                                       const SectionResult& result);

// "size=2 snap=0.1 ...": the same on one line; numbers with the fewest digits that read as the same number.
[[nodiscard]] std::string option_text(const std::vector<ReportItem>& options);

// The hash (pipeline/report/input_hash.hpp) of all files that the job reads: the inputs in order, then those
// of boundary, start mesh and prices. Throws Error(kInput).
[[nodiscard]] std::string hash_inputs(const SectionOptions& options);
// The files that it is of, with those that are read along with others.
[[nodiscard]] std::vector<std::string> input_files(const SectionOptions& options);

// Everything but command, version, threads and hash, which the caller knows. quality: of result.mesh.
[[nodiscard]] JobReport report_section(const SectionOptions& options, const SectionResult& result,
                                       QualitySummary quality);

}  // namespace quarry
