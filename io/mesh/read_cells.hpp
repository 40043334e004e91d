// What a reader collects from a file, and the mesh that is made of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

// What a file says of groups beside regions and lines: for each face and for each edge an index into the
// names, or -1; empty where it says it of none.
struct ReadGrouping {
  Grouping grouping;
  std::vector<std::int32_t> of_faces, of_edges;
};

struct ReadCells {
  std::vector<double> x, y, z;
  std::vector<FaceCorners> faces;
  std::vector<std::int32_t> regions;  // one for each face
  std::vector<std::pair<VertexId, VertexId>> edges;
  std::vector<std::int32_t> constraints;    // one for each edge
  std::vector<std::int32_t> kinds;          // one for each edge; empty: found from the faces
  std::vector<VertexId> points;             // vertices at points of the input
  std::vector<std::int32_t> point_numbers;  // one for each of them
  std::vector<ReadGrouping> groups;
  std::vector<double> apertures;  // one for each edge, NaN without; empty where no edge has one
  GroupNames names;
};

// The mesh with the tags region, constraint and kind, and with those of points, groups and apertures where
// there are some; planar if all z are 0. Edges that are no side of a face keep their place as long as both
// ends belong to faces; points without a face and edges to them are left out. Sheets in space may meet
// (build_sheets). Throws Error(kInput) naming the path for edges to points that do not exist, and for what
// build_mesh refuses.
[[nodiscard]] Mesh make_mesh(const std::string& path, ReadCells cells);

// Turns faces so that any two that share an edge pass it in opposite directions, and each connected part has
// a positive area: what clockwise faces, or a part of them, need before a mesh can be made. Faces that are
// bow-ties or folded over keep the direction that their neighbours tell. Edges of three faces or more are
// passed over. Returns the number of faces turned. Throws Error(kInput) naming the path and the place where a
// part has no two sides.
std::size_t turn_counterclockwise(const std::string& path, ReadCells& cells);

// What was read of groups, for a file that is written.
[[nodiscard]] std::vector<Grouping> groupings_of(const ReadCells& cells);

}  // namespace quarry
