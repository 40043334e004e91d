// Writes a mesh as a VTK XML unstructured grid (.vtu): faces, then its edges as VTK_LINE cells, with the cell
// data of docs/contract.md. Binary data are appended raw, with 64-bit block headers.
//
// Format: "VTK XML Formats", The VTK User's Guide, 11th edition, and the VTK file formats page of
// docs.vtk.org.
#pragma once

#include <string>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

// Memory beside the mesh is bounded (about 20 MB). Throws Error(kOutput).
void write_vtu(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

}  // namespace quarry
