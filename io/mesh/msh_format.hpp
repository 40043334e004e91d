// Gmsh .msh: written as 4.1 ASCII, read as 4.1 and 2.2, ASCII and binary. Each region is a surface with the
// physical group "region_<n>", each constraint line a curve with the group "line_<n>"; edges of the outer
// boundary are in "outer_boundary" too. Field texts stand in the $Comments section.
//
// Format: Gmsh reference manual, "Gmsh file formats".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Throws Error(kOutput).
void write_msh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Points, lines, triangles and quads of first order. A face's region is the number in the name of its
// physical group, or the tag of a group without a name; groups of other names, and surfaces without a group,
// count in order of appearance over the numbers that are left. Lines likewise; a line in several groups is
// read once for each. Throws Error(kInput) with file and line.
[[nodiscard]] ReadCells read_msh(const std::string& path);

}  // namespace quarry
