// The mesh into which the lines of a section are worked.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/linework/outline.hpp"
#include "pipeline/section/options.hpp"

namespace quarry {

// The direction of the start mesh in degrees: the one asked for; else that of the box where the outline is
// one, since a lattice along its sides meets them without a seam; else the one that the lines prefer.
[[nodiscard]] double find_orientation(const SectionOptions& options, OutlineRule rule,
                                      const NodedLines& lines);

// Triangles that reach beyond the cleaned lines on all sides, by the rule of options.start. spacing: the
// wanted edge of a triangle, in input units. Throws Error(kInput) for a start file that cannot be used.
[[nodiscard]] Mesh make_start_mesh(const SectionOptions& options, const NodedLines& lines, double spacing,
                                   double orient_degrees);

// The 4-8 lattice refined by a field of the wanted edges of triangles, of which `coarsest` is the largest.
// report: what its halvings did.
[[nodiscard]] Mesh make_graded_start(const NodedLines& lines, const SizeField& sizes, double coarsest,
                                     double orient_degrees, PassReport& report, const Progress& progress);

}  // namespace quarry
