// What the input says of its lines, on the edges of a mesh.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

// Gives each edge with a "constraint" what is known of that line, as tags: "name", "set" and "material" (each
// an index into names, in the order in which the lines bring them; -1 without), "file" where there are
// several files (an index into their group names), and "aperture" (NaN without). Only tags that some line has
// are made. paths: of the files. Returns the names.
[[nodiscard]] std::vector<Grouping> tag_lines(Mesh& mesh, const LineSet& lines,
                                              const std::vector<std::string>& paths);

// Gives the edges on the boundary of a mesh of a box the tag "box_side", and adds the grouping: an edge is on
// the left, the right, at the bottom or at the top; -1 for all others.
void tag_box_sides(Mesh& mesh, std::vector<Grouping>& groups);

// What the groups of files are called: the names of files without folder and extension, "stdin" for standard
// input; "_2" and so on tell those apart that would be the same.
[[nodiscard]] std::vector<std::string> file_group_names(const std::vector<std::string>& paths);

}  // namespace quarry
