// The faces of a mesh in space as the surface that an improved mesh has to lie on.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/read_cells.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

struct FaceSurface {
  // Points are those of the file; quads are two triangles. The groups are the regions, and of the report of
  // repair nothing is filled: a mesh is not repaired.
  RepairedSurface triangles;
  // The edges that divide a quad, ascending.
  std::vector<SheetJoin> within;
  double mean_side = 0;      // the mean length of the sides of faces, in input units
  std::size_t turned = 0;    // faces
  std::size_t welded = 0;    // points that went into another at the same place
  std::size_t narrowed = 0;  // quads with two corners at one place, which are triangles now
};

// Points at one place become one, in faces, edges and points of the cells, as a surface is one that hangs
// together. Turns faces so that neighbours agree on which side is up, in each connected part as the larger
// part of it does already; sheets end where three faces or more share an edge, and where a part has no two
// sides. A quad is divided along its shorter diagonal, if it is convex as seen along its normal and no other
// face has that as an edge or a diagonal; else along the other one. Throws Error(kInput) naming the path for
// faces that name a point which does not exist, and Error(kGeometry) for faces with fewer than three places
// and for a quad neither of whose diagonals is free.
[[nodiscard]] FaceSurface make_face_surface(const std::string& path, ReadCells& cells);

// The faces themselves as a mesh, with the vertices and kSurfacePointTag of its triangles (make_sheets).
// faces: those of the cells that the surface was made of.
[[nodiscard]] Mesh make_face_mesh(const FaceSurface& surface, const Mesh& sheets,
                                  const std::vector<FaceCorners>& faces);

// How far, in input units, rounding within the digits of a file may take a point off a line: 1e-9 of the
// longer side of the box of all triangles, or what their coordinates tell apart.
[[nodiscard]] double rounding_of(const TriangleSurface& surface);

}  // namespace quarry
