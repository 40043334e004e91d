// Which triangle holds a point.
#pragma once

#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry::deferred {

enum class Place { kOutside, kFace, kEdge, kVertex };

struct Location {
  Place place = Place::kOutside;
  SideId side;  // kFace: any side of the face; kEdge: the edge; kVertex: a side that starts there
};

// Walks from a vertex to the triangle that holds p (exact). kOutside: the walk left the mesh, which for a
// mesh whose hull is convex means that p is outside. Where several triangles hold p (on an edge) either may
// be returned.
[[nodiscard]] Location locate(const Mesh& mesh, VertexId start, Vec2 p);

// A vertex near any point, by a coarse grid over the mesh: where walks start.
class VertexGrid {
 public:
  explicit VertexGrid(const Mesh& mesh);
  [[nodiscard]] VertexId near(Vec2 p) const;

 private:
  [[nodiscard]] std::size_t cell_of(Vec2 p) const;

  Box2 box_;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<VertexId> cells_;
};

}  // namespace quarry::deferred
