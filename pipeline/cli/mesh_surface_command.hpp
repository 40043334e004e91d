// `quarry mesh` on a triangulated surface.
#pragma once

#include <string>
#include <vector>

#include "pipeline/cli/mesh_arguments.hpp"

namespace quarry::cli {

// True if the first input is a mesh file by its extension: then all are taken as one surface.
[[nodiscard]] bool is_surface(const std::vector<std::string>& inputs);

// All files that such a job reads.
[[nodiscard]] std::vector<std::string> surface_input_files(const MeshArguments& arguments);

// Checks, meshes, writes and tells. Throws Error.
void run_mesh_surface(MeshArguments& arguments);

}  // namespace quarry::cli
