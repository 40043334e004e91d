// The star of one vertex, ready to be measured with the vertex elsewhere: what every guarded move is judged
// by.
#pragma once

#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// How good a face is, for comparison only: no square roots, signs kept.
//   quad      the smallest sin |sin| of its corners, times min(1, (4 shortest edge / longest edge)^2). The
//   second
//             factor is what a scaled Jacobian lacks: it is blind to edges that shrink to nothing.
//   triangle  the signed square of Lo's measure.
// Both lie in [-1, 1]; a square and an equilateral triangle have 1.
class Star {
 public:
  // Reads the faces around v. Keeps its memory from one star to the next.
  void gather(const Mesh& mesh, VertexId v);

  [[nodiscard]] Vec2 place() const { return place_; }
  // The mean of the joined vertices, relative to place().
  [[nodiscard]] Vec2 umbrella() const { return umbrella_; }
  // The squared length of the shortest edge at the vertex.
  [[nodiscard]] double shortest_squared() const { return shortest_squared_; }

  // The measure of the worst face, were the vertex at place() + offset. Gives up, with some value below the
  // floor, once a face is below it.
  [[nodiscard]] double worst(Vec2 offset, double floor) const;

  // True if every corner of the star turns left were the vertex at p (exact).
  [[nodiscard]] bool valid_at(Vec2 p) const;

 private:
  struct Face {
    Vec2 next, opposite, previous;  // relative to place_; the opposite corner of quads only
    double opposite_corner;         // its sin |sin|, which no move changes
    double shortest, longest;       // squares, of the edges that no move changes
    bool quad;
  };
  [[nodiscard]] static double measure_quad(const Face& face, Vec2 offset);
  [[nodiscard]] static double measure_triangle(const Face& face, Vec2 offset);

  Vec2 place_, umbrella_;
  double shortest_squared_ = 0;
  std::vector<Face> faces_;
  std::vector<Vec2> corners_;  // of each face: next, opposite, previous, as stored in the mesh
};

}  // namespace quarry
