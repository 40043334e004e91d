// Faces and edges of a mesh in the groups that formats with named groups write.
#pragma once

#include <cstdint>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

// Neighbours [begin, end) of a sorted list that share region and number of corners.
struct FaceGroup {
  std::int32_t region = 0;
  int corners = 4;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Neighbours of a sorted list that share constraint, kind and side.
struct EdgeGroup {
  std::int32_t constraint = -1;
  std::int32_t kind = kInteriorConstraint;
  std::int32_t side = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Faces by region, then triangles before quads; edges by constraint, then side, then kind; ties in id order.
struct GroupedEntities {
  std::vector<FaceId> faces;
  std::vector<FaceGroup> face_groups;
  std::vector<EdgeId> edges;
  std::vector<std::uint32_t> edge_places;  // of each of them in LiveNumbering::edges()
  std::vector<EdgeGroup> edge_groups;
};

[[nodiscard]] GroupedEntities group_entities(const Mesh& mesh, const LiveNumbering& numbering);

}  // namespace quarry
