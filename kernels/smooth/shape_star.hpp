// The star of one vertex as the shape optimiser sees it: an energy of the vertex's place with its first and
// second derivatives.
//
// A corner between edges e1 and e2 with determinant d = e1 x e2 costs
//   (|e1|^2 / r + r |e2|^2 + s T) / d + s d / T,
// the mean ratio of Knupp (SIAM J. Sci. Comput. 23, 2001) with two changes. r is the present aspect, so that
// a rectangle is as good as a square and a quad is not skewed where counts ask for a stretch. T is the wanted
// area, and s how much it counts. With r fixed, as for the derivatives, the cost is convex in the place as
// long as all d > 0 (squares over a linear function), and infinite at d = 0: Newton's method needs no help.
//
// Where a corner is turned over, chi(d) = (d + sqrt(d^2 + eps^2)) / 2 stands in place of the d below
// (Escobar et al., CMAME 192, 2003): finite everywhere, falling as d grows. It also serves where a corner is
// nearly flat: on the plain cost Newton's steps from there are no longer than d itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "kernels/smooth/quadratic.hpp"

namespace quarry {

// Whose aspect r is.
enum class Stretch : std::uint8_t {
  kOfQuad,    // one for its four corners: opposite edges become equal
  kOfCorner,  // of its two edges: without s the cost is 2 / sine
};

struct ShapeTarget {
  Stretch stretch = Stretch::kOfQuad;
  // s: what the size of a face counts beside its shape.
  double size_weight = 0.1;
  // r is at most this and at least its inverse: what is longer is drawn back.
  double largest_aspect = 3;
};

// r at the vertex, at `next` and at `previous`: of the edge to `next` or the one across from it by the other.
struct CornerStretch {
  double here = 1, next = 1, previous = 1;
};

// A face of a star; places are relative to the vertex.
struct ShapeFace {
  Vec2 next, previous;  // the corners joined to the vertex
  Vec2 far_next,
      far_previous;  // of a quad: the edges from `next` to the opposite corner and on to `previous`
  double far_next_squared, far_previous_squared;  // of a triangle both that of its far edge
  double area;                                    // T
  CornerStretch stretch;                          // with the vertex where it is
  bool quad;
};

class ShapeStar {
 public:
  explicit ShapeStar(const ShapeTarget& target = {}) : target_(target) {}

  // Empties the star; its memory is kept.
  void clear() {
    count_ = 0;
    following_ = false;
  }
  // Faces in any order, corners counter-clockwise from the vertex, places relative to it. area: wanted, of a
  // quad; of a triangle twice its own.
  void add_quad(Vec2 next, Vec2 opposite, Vec2 previous, double area);
  void add_triangle(Vec2 next, Vec2 previous, double area);
  // From here on r of each quad is its aspect with the vertex at the offset that is asked about; before, it
  // is 1 wherever the vertex is.
  void follow_stretch();

  [[nodiscard]] std::span<const ShapeFace> faces() const { return std::span(faces_).first(count_); }
  // The mean of the squared lengths of the edges at the vertex.
  [[nodiscard]] double mean_squared_edge() const;

  // Whether a corner that changes with the vertex has a sine below the one given (not negative).
  [[nodiscard]] bool has_corner_below(double sine) const;

  // The energy were the vertex at this offset. With eps 0 (an area) it is infinite unless all corners turn
  // left.
  [[nodiscard]] double value(Vec2 offset, double eps) const;
  // The energy where the vertex is, with its derivatives for fixed r. With an infinite value they mean
  // nothing.
  [[nodiscard]] Quadratic expand(double eps) const;
  // True if with the vertex at the offset no face has a corner (of those that change) with a sine below the
  // floor and smaller than now, or edges of a ratio above the limit and more unequal than now.
  [[nodiscard]] bool keeps(Vec2 offset, double floor, double largest_edge_ratio) const;

 private:
  ShapeFace& add();
  [[nodiscard]] CornerStretch stretch_at(const ShapeFace& face, Vec2 offset) const;

  ShapeTarget target_;
  bool following_ = false;
  std::size_t count_ = 0;
  std::vector<ShapeFace> faces_;  // the first count_ are those of this star
};

}  // namespace quarry
