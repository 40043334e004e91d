// What the input says of its lines and points, in a report.
#pragma once

#include <cstdint>

#include "engine/geometry/line_set.hpp"
#include "pipeline/report/job_report.hpp"

namespace quarry {

// As far as it says anything. first_file: the number of the first file of the lines among all input files.
void describe_lines(const LineSet& lines, std::uint32_t first_file, JobReport& report);

}  // namespace quarry
