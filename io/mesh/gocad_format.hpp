// GOCAD's ASCII files of triangulated surfaces: .ts, and .ml, in which a Model3d names the surfaces whose
// triangles follow in the same file. Read: every TSurf, with VRTX, PVRTX, ATOM, PATOM and TRGL; each is a
// region with its name. The z of a surface whose ZPOSITIVE is Depth is turned over, so that z is up
// everywhere. Properties, borders, corners, the regions and faces of a Model3d, and objects of other sorts
// are passed over.
//
// Points are those of the file: where surfaces, or the parts (TFACE) of one, touch, each has points of its
// own.
//
// Format: GOCAD User Guide, "GOCAD ASCII files".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Throws Error(kInput) with file and line, also for a file without any TSurf.
[[nodiscard]] ReadCells read_gocad(const std::string& path);

}  // namespace quarry
