// Reads a VTK XML unstructured grid (.vtu): ascii, base64 inline, or appended raw or base64, with or without
// zlib.
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Lines, polylines, triangles, quads, pixels and polygons of three or four corners; points as cells are
// skipped. The cell data region, constraint and kind become tags; in place of the first two also
// gmsh:physical, CellEntityIds or MaterialIDs. Missing ones are found as MeshFileTags says. Other data are
// not read. Throws Error(kInput) with the array or the cell.
[[nodiscard]] ReadCells read_vtu(const std::string& path);

}  // namespace quarry
