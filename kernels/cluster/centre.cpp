#include "kernels/cluster/centre.hpp"

#include <algorithm>

#include "engine/geometry/predicates.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/cluster/pair_measure.hpp"

namespace quarry {
namespace {

double worst_corner(const CentreProblem& problem, Vec2 centre) {
  const std::size_t n = problem.corners.size();
  double worst = 1;
  for (std::size_t i = 0; i < n; ++i)
    worst = std::min(worst, worst_corner_signed_square(problem.corners[i], problem.midpoints[i], centre,
                                                       problem.midpoints[(i + n - 1) % n]));
  return worst;
}

bool valid_quad(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return orient2d(a, b, c) > 0 && orient2d(b, c, d) > 0 && orient2d(c, d, a) > 0 && orient2d(d, a, b) > 0;
}

bool all_quads_valid(const CentreProblem& problem, Vec2 centre) {
  const std::size_t n = problem.corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!valid_quad(problem.corners[i], problem.midpoints[i], centre, problem.midpoints[(i + n - 1) % n]))
      return false;
  return true;
}

// The candidates are formed relative to the first corner.
Vec2 average(const CentreProblem& problem) {
  const Vec2 origin = problem.corners[0];
  Vec2 sum;
  for (std::size_t i = 1; i < problem.corners.size(); ++i) sum = sum + (problem.corners[i] - origin);
  return origin + (1.0 / static_cast<double>(problem.corners.size())) * sum;
}

class BestCandidate {
 public:
  explicit BestCandidate(const CentreProblem& problem) : problem_(problem) {}

  void offer(Vec2 p) {
    const double quality = worst_corner(problem_, p);
    if (best_ && quality <= quality_) return;
    if (!all_quads_valid(problem_, p)) return;
    best_ = p;
    quality_ = quality;
  }
  [[nodiscard]] std::optional<Vec2> point() const { return best_; }
  // Good enough to stop looking.
  [[nodiscard]] bool good() const { return best_ && quality_ > 0.25; }

 private:
  const CentreProblem& problem_;
  std::optional<Vec2> best_;
  double quality_ = -2;
};

}  // namespace

std::optional<Vec2> best_centre(const CentreProblem& problem) {
  BestCandidate best(problem);
  const Vec2 middle = average(problem);
  best.offer(middle);
  if (best.good()) return best.point();
  if (problem.corners.size() == 4)
    best.offer(
        crossing_point(problem.corners[0], problem.corners[2], problem.corners[1], problem.corners[3]));
  for (std::size_t i = 0; i < problem.corners.size(); ++i) {
    for (const double t : {0.25, 0.5, 0.75}) {
      best.offer(middle + t * (problem.corners[i] - middle));
      best.offer(middle + t * (problem.midpoints[i] - middle));
    }
  }
  return best.point();
}

}  // namespace quarry
