// What cutting low quads did, as counts of a report.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/cluster/low_quads.hpp"
#include "pipeline/report/job_report.hpp"

namespace quarry {

inline void add_low_quads(std::vector<ReportItem>& counts, const LowQuadReport& report) {
  counts.push_back({"quads_below_quality", static_cast<std::int64_t>(report.low)});
  counts.push_back({"quads_cut", static_cast<std::int64_t>(report.cut)});
}

}  // namespace quarry
