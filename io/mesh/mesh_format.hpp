// Mesh files by the extension of their name.
#pragma once

#include <string>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/read_cells.hpp"

namespace quarry {

// Writes the format that the extension names, in either case of letters. A file appears whole or not at all.
// Throws Error(kUsage) for an extension that is not known or read only, Error(kOutput) where nothing can be
// written.
void write_mesh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Reads a file into a mesh with the tags region (faces), constraint and kind (edges). Throws Error(kUsage)
// for an extension that is not known, Error(kInput) with the place for a file that cannot be read or is
// broken.
[[nodiscard]] Mesh read_mesh(const std::string& path);

// The same before a mesh is made of it (io/mesh/read_cells.hpp), with usable coordinates
// (io/coordinate_limit.hpp): for who must look at it first, or needs the names of its groups.
[[nodiscard]] ReadCells read_cells(const std::string& path);

// Throws Error(kUsage) unless read_mesh, or write_mesh, knows the extension: for a check before a long job.
void check_readable_extension(const std::string& path);
void check_writable_extension(const std::string& path);

// Throws Error(kUsage) unless write_mesh can write elements of that order in the format of the extension.
void check_writable_order(const std::string& path, ElementOrder order);

// Throws Error(kUsage) unless write_mesh writes a form for that program in the format of the extension.
void check_writable_for(const std::string& path, MeshConsumer consumer);

// ".vtu, .msh or .obj": the extensions that read_mesh, or write_mesh, knows.
[[nodiscard]] std::string readable_mesh_formats();
[[nodiscard]] std::string writable_mesh_formats();

// True if read_mesh knows the extension.
[[nodiscard]] bool is_mesh_file(const std::string& path);

}  // namespace quarry
