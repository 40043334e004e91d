// The points of the input on the vertices of a mesh.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry {

// Gives the vertices at points of the input the tag kPointTag: the smallest number of the points there, -1
// elsewhere. The mesh has ConstraintTags. Does nothing where the input has no points. Throws Error(kBug) if a
// point that was not dropped has no vertex in its place.
void tag_points(Mesh& mesh, const CleanedLines& cleaned);

// The names that the input gives its points, as far as they are names of one point alone.
[[nodiscard]] std::map<std::int32_t, std::string> point_names(const LineSet& lines);

}  // namespace quarry
