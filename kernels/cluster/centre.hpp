// Where the centre of a face should lie when its edges are halved.
#pragma once

#include <array>
#include <optional>

#include "engine/geometry/vec.hpp"

namespace quarry {

// Up to four points; a vector without the heap.
class FewPoints {
 public:
  void push_back(Vec2 p) { points_[size_++] = p; }
  [[nodiscard]] std::size_t size() const { return size_; }
  Vec2 operator[](std::size_t i) const { return points_[i]; }

 private:
  std::array<Vec2, 4> points_{};
  std::size_t size_ = 0;
};

// A triangle or quad, and the rounded midpoint of the edge from each corner to the next.
struct CentreProblem {
  FewPoints corners;
  FewPoints midpoints;
};

// Of several candidates (the average of the corners, the crossing of a quad's diagonals, places nearer to one
// corner) the one whose worst quad corner is best among those that leave every quad valid (exact); none if no
// candidate does.
[[nodiscard]] std::optional<Vec2> best_centre(const CentreProblem& problem);

}  // namespace quarry
