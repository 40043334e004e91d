// VTKHDF (.vtkhdf, .hdf): an UnstructuredGrid of version 1.0 in an HDF5 file, with the same arrays as a .vtu,
// for ParaView from 5.10 on. Written only: the HDF5 library is not made for files that are broken on purpose.
//
// Format: VTK documentation, "VTKHDF file format".
#pragma once

#include <string>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

// compress: deflate, in chunks. The bytes are the same on any number of threads, and hold no time. Throws
// Error(kOutput).
void write_vtkhdf(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

}  // namespace quarry
