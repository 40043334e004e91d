// Abaqus input files (.inp), the mesh in them. Read: nodes; elements of two, three and four nodes, whatever
// their type is called; element sets, also of sections; surfaces made of element edges. Everything else
// (materials, steps, node sets) is skipped. Coordinates are those of the part: instances are not placed.
//
// Format: Abaqus Keywords Reference, *NODE, *ELEMENT, *ELSET, *SURFACE.
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Faces as CPS3 and CPS4 (S3 and S4 in space) in element sets "region_<n>", edges as surfaces "line_<n>",
// those of the boundary that have no number as "outer_boundary". An edge that is no side of a face is a T2D2
// (T3D2) element. Node sets "line_<n>" and "outer_boundary" hold the nodes of each line and of the whole
// boundary. Throws Error(kOutput).
void write_inp(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// A face's region is the element set of a section that holds it, else the first *ELSET that holds it and not
// all faces, else the set that its *ELEMENT names. A line element is read once for each *ELSET that holds it,
// else for the set that its *ELEMENT names; a surface gives the edges of its elements its name. Sets are
// numbered as the groups of a .msh file are. Throws Error(kInput) with file and line, also for elements of
// other sorts and for keywords that make nodes and elements or read them from elsewhere (*INCLUDE, *NGEN,
// ...).
[[nodiscard]] ReadCells read_inp(const std::string& path);

}  // namespace quarry
