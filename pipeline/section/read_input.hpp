// The input of a section job: its lines, in the plane that they are meshed in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "pipeline/section/options.hpp"

namespace quarry {

struct SectionInput {
  LineSet lines;
  std::optional<LineSet> boundary;  // where the outline is a file
  std::string projected;            // the plane that degrees were brought to; "" if they were not
  std::string system;               // of the coordinates as they are now; "" if unknown, or not one
  std::vector<std::string> notes;   // one line each: what the user should know
};

// Reads the files. Throws Error(kInput) as read_lines; for coordinates in degrees, unless they are to be
// projected or taken as they are; and for lines that all stand in vertical planes, unless one of those is
// chosen. Throws Error(kUsage) for a choice that makes no sense for this input.
[[nodiscard]] SectionInput read_section_input(const SectionOptions& options, const Progress& progress);

}  // namespace quarry
