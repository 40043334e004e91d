// `quarry mesh` on a triangulated surface.
#pragma once

#include <string>
#include <vector>

#include "pipeline/cli/mesh_arguments.hpp"

namespace quarry::cli {

// True if the first input is a mesh file by its extension: then all are taken as one surface.
[[nodiscard]] bool is_surface(const std::vector<std::string>& inputs);

// Checks, meshes, writes and tells. Throws Error.
void run_mesh_surface(MeshArguments& arguments);

}  // namespace quarry::cli
