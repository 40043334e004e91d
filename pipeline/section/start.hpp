// The mesh into which the lines of a section are worked.
#pragma once

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "pipeline/section/options.hpp"

namespace quarry {

// The direction of the start mesh in degrees: the one asked for, or that of the lines.
[[nodiscard]] double find_orientation(const SectionOptions& options, const NodedLines& lines);

// Triangles that reach beyond the cleaned lines on all sides, by the rule of options.start. spacing: the
// wanted edge of a triangle, in input units. Throws Error(kInput) for a start file that cannot be used.
[[nodiscard]] Mesh make_start_mesh(const SectionOptions& options, const NodedLines& lines, double spacing,
                                   double orient_degrees);

}  // namespace quarry
