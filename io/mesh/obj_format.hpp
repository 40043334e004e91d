// Wavefront .obj: points, triangles and quads in groups "region_<n>", edges as lines in groups "line_<n>" and
// "outer_boundary". Texture coordinates, normals and materials are ignored when read and never written.
#pragma once

#include <string>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Throws Error(kOutput).
void write_obj(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Faces as "a", "a/b", "a//c" or "a/b/c", numbers from the end of the list as negative ones. Throws
// Error(kInput) with file and line.
[[nodiscard]] ReadCells read_obj(const std::string& path);

}  // namespace quarry
