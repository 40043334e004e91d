// The star of one vertex, ready to be measured with the vertex elsewhere: what every guarded move is judged
// by.
#pragma once

#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// A face of a star. Places are relative to where the vertex stood when the star was gathered. What no move of
// the vertex changes is kept: the far edges and the corner between them.
struct StarFace {
  FaceId id;
  Vec2 next, previous;  // the corners joined to the vertex
  Vec2 far_next,
      far_previous;  // of a quad: the edges from `next` to the opposite corner and from there to `previous`
  double far_next_squared,
      far_previous_squared;  // their squared lengths; of a triangle both that of its far edge
  bool quad;
  // Set by weigh(): sin |sin| between the far edges (1 for a triangle), and the measure of the face as
  // gathered.
  double far_corner, measure;
  // The corners as stored in the mesh.
  Vec2 at_next, at_opposite, at_previous;
};

// How good a face is, for comparison only: no square roots, signs kept.
//   quad      1 / (1 / sin^2 + a) of its smallest corner sine, and sin |sin| where that is not positive. a is
//   an
//             aspect guard: what a scaled Jacobian lacks, which is blind to edges that shrink to nothing.
//             With r the harmonic by the arithmetic mean of the fourth powers of the edges
//             a = max(0, (1 / 145 r)^2 - 1): nothing up to 4.9 times as long as wide, 49 at eight times,
//             where a rectangle counts like a square corner of sine 0.14. Costs that add up let a wedge whose
//             tip no move can help still trade length for angles. Means in place of extremes let each end of
//             a short or a long edge help alone; of squares they would not see one short edge beside three
//             long ones up to a ratio of seven.
//   triangle  the signed square of Lo's measure.
// Both lie in [-1, 1]; a square and an equilateral triangle have 1.
class Star {
 public:
  // Reads the faces around v. Keeps its memory from one star to the next.
  void gather(const Mesh& mesh, VertexId v);
  // Measures the faces as they are: needed before worst() and badness_at().
  void weigh();

  [[nodiscard]] std::span<const StarFace> faces() const { return std::span(faces_).first(count_); }
  [[nodiscard]] Vec2 place() const { return place_; }
  // The mean of the joined vertices, relative to place().
  [[nodiscard]] Vec2 umbrella() const { return umbrella_; }
  // The squared length of the shortest edge at the vertex.
  [[nodiscard]] double shortest_squared() const { return shortest_squared_; }
  // The mean of the squared lengths of the edges at the vertex.
  [[nodiscard]] double mean_squared() const { return mean_squared_; }
  // The measure of the worst face.
  [[nodiscard]] double worst() const { return worst_; }

  // The sum of 1 / measure of the faces, were the vertex at place() + offset; infinite if one is worse than
  // the worst is now. Unlike the minimum it tells better from worse also where a face that no move can help
  // has the minimum.
  [[nodiscard]] double badness_at(Vec2 offset) const;
  // True if no face would fall below the bar (positive) that is above it now, nor any other become worse.
  [[nodiscard]] bool keeps_faces(Vec2 offset, double bar) const;
  // True if no quad would have a longest edge beyond so many times its shortest, and more unequal edges than
  // now.
  [[nodiscard]] bool keeps_edge_ratios(Vec2 offset, double limit) const;
  // The same of triangles, whose measure does not tell: in a wedge it is best where both long edges are
  // equal.
  [[nodiscard]] bool keeps_triangles(Vec2 offset, double limit) const;
  // The measure of one face, without a star.
  [[nodiscard]] static double measure_of(const Mesh& mesh, FaceId f);
  // True if every corner of the star turns left were the vertex at p (exact).
  [[nodiscard]] bool valid_at(Vec2 p) const;

 private:
  Vec2 place_, umbrella_;
  double shortest_squared_ = 0;
  double mean_squared_ = 0;
  double worst_ = 1;
  std::size_t count_ = 0;
  std::vector<StarFace> faces_;  // the first count_ are those of this star
};

// For faces whose corners move at once: as Star::keeps_faces, keeps_edge_ratios and valid_at. Three or four
// corners, counter-clockwise; true for a face that stays as it is.
[[nodiscard]] bool keeps_face(std::span<const Vec2> before, std::span<const Vec2> after, double bar,
                              double edge_ratio);

}  // namespace quarry
