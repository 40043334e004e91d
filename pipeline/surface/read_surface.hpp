// Triangulated surfaces from mesh files.
#pragma once

#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "surface/repair/triangle_surface.hpp"

namespace quarry {

// All files as one surface. Quads are cut along their shorter diagonal. Groups are the regions of the files;
// those of further files get the numbers that follow, and their names are kept. Throws Error as io/mesh does.
[[nodiscard]] TriangleSurface read_surface(const std::vector<std::string>& paths, GroupNames& names);

}  // namespace quarry
