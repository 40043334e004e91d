// What an improve job tells about itself.
#pragma once

#include <string>
#include <vector>

#include "pipeline/improve/improve.hpp"
#include "pipeline/report/job_report.hpp"

namespace quarry {

// The options that change the mesh, with the defaults that were filled in.
[[nodiscard]] std::vector<ReportItem> resolved_options(const ImproveOptions& options,
                                                       const ImproveResult& result);

// The hash (pipeline/report/input_hash.hpp) of the mesh and of the raster of prices. Throws Error(kInput).
[[nodiscard]] std::string hash_inputs(const ImproveOptions& options);

// Everything but version, threads and hash, which the caller knows. quality: of result.mesh.
[[nodiscard]] JobReport report_improvement(const ImproveOptions& options, const ImproveResult& result,
                                           QualitySummary quality);

}  // namespace quarry
