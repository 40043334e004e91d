// Geomview's Object File Format (.off), in its text form: points, triangles and quads. Normals, colours and
// texture coordinates (NOFF, COFF, STOFF) are passed over, as are comments. One point or face stands on a
// line.
//
// Format: Geomview Manual, "OFF Files".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Throws Error(kInput) with file and line, also where the counts announce more or fewer lines than there are,
// and for the binary form and points of four or n coordinates.
[[nodiscard]] ReadCells read_off(const std::string& path);

}  // namespace quarry
