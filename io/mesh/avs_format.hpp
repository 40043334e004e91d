// AVS UCD, the text form (.avs, .ucd), as AVS/Express, LaGriT and ParaView know it: triangles, quads and
// lines.
//
// Format: AVS/Express Developer's Reference, "UCD ASCII file format"; LaGriT manual, "read / avs".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Faces first, then edges, with the cell data region, constraint and kind. The material of a cell is one more
// than its number in MaterialNumbers. Field texts are comments. Throws Error(kOutput).
void write_avs(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Points and cells with any numbers; cells `pt` are passed over. Without the cell data that write_avs gives,
// the material is the region of a face and the number of a line. Throws Error(kInput) with file and line,
// also for other cells, and where the counts announce more or fewer lines than there are.
[[nodiscard]] ReadCells read_avs(const std::string& path);

}  // namespace quarry
