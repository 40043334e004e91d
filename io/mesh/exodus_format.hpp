// Exodus II (.exo, .e), for MOOSE, SIERRA and ParaView: written where quarry is built with QUARRY_EXODUS.
//
// Format: Schoof & Yarberry, EXODUS II: a finite element data model, SAND92-2137.
#pragma once

#include <string>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

// Each region is a block of elements (one more for its triangles, "..._triangles", where it has quads too),
// and so is the interior part of each line, of bars, each edge in one of them. The outer boundary and each
// line are side sets: an interior one has the sides of the faces on both sides of it. Names are cut off after
// 32 bytes. Throws Error(kOutput).
void write_exodus(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

}  // namespace quarry
