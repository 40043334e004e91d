// The page of a mesh, with the figures that the command tells.
#pragma once

#include <string>

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/summary.hpp"

namespace quarry::cli {

// source: the file that the mesh comes from; its name stands on top. Throws as write_page (io/page/page.hpp).
void write_mesh_page(const std::string& path, const Mesh& mesh, const QualitySummary& quality,
                     const std::string& source);

}  // namespace quarry::cli
