// What a surface job tells about itself.
#pragma once

#include <string>
#include <vector>

#include "pipeline/report/job_report.hpp"
#include "pipeline/surface/surface.hpp"

namespace quarry {

// The options that change the mesh, with the defaults that were filled in.
[[nodiscard]] std::vector<ReportItem> resolved_options(const SurfaceOptions& options,
                                                       const SurfaceResult& result);

// Everything but command, version, threads and hash, which the caller knows. quality: of result.mesh.
[[nodiscard]] JobReport report_surface(const SurfaceOptions& options, const SurfaceResult& result,
                                       QualitySummary quality);

}  // namespace quarry
