// MFEM mesh v1.0 (.mesh): triangles and quads in the plane or in space, and edges as its boundary.
//
// Format: MFEM documentation, "Mesh formats".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// The attribute of an element is its region + 1, or what makes the smallest 1 where there is a region below
// 0. Boundary elements are the edges that are a side of a face, interior ones too, each once, with the
// smallest number of its lines: the attribute is that number + 2, and 1 for an edge without. Field texts are
// comments. Throws Error(kOutput).
void write_mfem(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Straight meshes of the versions 1.0 to 1.3 in two dimensions; one element, boundary element or vertex
// stands on a line. Throws Error(kInput) with file and line, also for curved meshes and for elements that are
// no triangles or squares.
[[nodiscard]] ReadCells read_mfem(const std::string& path);

}  // namespace quarry
