#include "kernels/deferred/polygon_plan.hpp"

#include <algorithm>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"

namespace quarry::deferred {
namespace {

// Polygons of more corners than this are cut by the Delaunay rule, which costs less than the best
// triangulation.
constexpr std::size_t kMostForBest = 160;

}  // namespace

PolygonPlan::PolygonPlan(std::vector<Vec2> points) : points_(std::move(points)) {
  if (points_.size() <= kMostForBest) find_best();
}

std::size_t PolygonPlan::apex(std::size_t i, std::size_t j) const {
  if (!apex_.empty()) return apex_[i * points_.size() + j];
  std::size_t chosen = i;
  for (std::size_t k = i + 1; k < j; ++k) {
    if (!(orient2d(points_[i], points_[k], points_[j]) > 0)) continue;
    if (chosen == i || incircle(points_[i], points_[chosen], points_[j], points_[k]) > 0) chosen = k;
  }
  return chosen;
}

double PolygonPlan::quality(std::size_t i, std::size_t k, std::size_t j) const {
  return orient2d(points_[i], points_[k], points_[j]) > 0 ? lo_measure(points_[i], points_[k], points_[j])
                                                          : -1;
}

// best[i, j]: the best worst measure of a triangulation of corners i..j, by all choices of the apex over i-j.
void PolygonPlan::find_best() {
  const std::size_t n = points_.size();
  std::vector<double> best(n * n, 2.0);
  apex_.assign(n * n, 0);
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      best[i * n + j] = -2;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double worst = std::min({quality(i, k, j), best[i * n + k], best[k * n + j]});
        if (worst > best[i * n + j]) {
          best[i * n + j] = worst;
          apex_[i * n + j] = k;
        }
      }
    }
  }
  worst_ = best[n - 1];
}

}  // namespace quarry::deferred
