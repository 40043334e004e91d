#include "pipeline/report/line_description.hpp"

#include <algorithm>

namespace quarry {

void describe_lines(const LineSet& lines, std::uint32_t first_file, JobReport& report) {
  const IdRange<LineId> all(lines.lines.size());
  if (!lines.attributes.empty())
    for (const LineId id : all) report.line_attributes.push_back(lines.attributes_of(id));
  if (!lines.attributes.empty())
    for (const PointId id : IdRange<PointId>(lines.points.size()))
      report.point_attributes.push_back(lines.attributes_of(id));
  if (lines.files.size() > 1)
    for (const LineId id : all) report.line_files.push_back(first_file + lines.lines[id].file);
  if (std::ranges::all_of(lines.systems, [](const CoordinateSystem& s) { return s.definition.empty(); }))
    return;
  for (const CoordinateSystem& system : lines.systems) report.coordinate_systems.push_back(system.definition);
}

}  // namespace quarry
