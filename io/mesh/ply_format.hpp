// Stanford's polygon format (.ply): read as text and as binary in either order of bytes, with numbers of any
// type; written as binary, little-endian. Elements and properties other than those below are passed over.
//
//   vertex   x, y, z (0 where there is none)
//   face     the list vertex_indices or vertex_index, of 3 or 4 points; region, a whole number
//   edge     vertex1, vertex2; constraint and kind, whole numbers
//
// In text, each row of an element stands on a line of its own.
//
// Format: G. Turk, "The PLY Polygon File Format".
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Coordinates are doubles. Edges stand last, for programs that read faces alone. Names of groups have no
// place. Throws Error(kOutput).
void write_ply(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Throws Error(kInput) with file and line, or byte in a binary body, also for counts that do not agree with
// what follows and for triangle strips.
[[nodiscard]] ReadCells read_ply(const std::string& path);

}  // namespace quarry
