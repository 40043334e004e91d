#include "engine/geometry/straight_runs.hpp"

#include <algorithm>
#include <utility>

#include "engine/geometry/segment.hpp"
#include "engine/geometry/space_segment.hpp"

namespace quarry {
namespace {

// The point strictly between two that must be a bend, or `first` if there is none: the farthest from the
// segment if that is too far, else one that does not come after its predecessor.
template <class Vec>
std::uint32_t worst_between(std::span<const Vec> points, std::uint32_t first, std::uint32_t last,
                            double tolerance) {
  const Vec a = points[first];
  const Vec b = points[last];
  double farthest = tolerance * tolerance;
  std::uint32_t worst = first;
  for (std::uint32_t i = first + 1; i < last; ++i) {
    const double away = squared_distance(points[i], a, b);
    if (away > farthest) {
      farthest = away;
      worst = i;
    }
  }
  if (worst != first) return worst;
  double before = 0;
  for (std::uint32_t i = first + 1; i < last; ++i) {
    const double along = projection_parameter(points[i], a, b);
    if (!(along > before) || !(along < 1)) return i;
    before = along;
  }
  return first;
}

template <class Vec>
std::vector<std::uint32_t> bends_of(std::span<const Vec> points, double tolerance) {
  const auto last = static_cast<std::uint32_t>(points.size() - 1);
  std::vector<std::uint32_t> bends{0, last};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> todo{{0, last}};
  while (!todo.empty()) {
    const auto [from, to] = todo.back();
    todo.pop_back();
    const std::uint32_t worst = worst_between(points, from, to, tolerance);
    if (worst == from) continue;
    bends.push_back(worst);
    todo.emplace_back(from, worst);
    todo.emplace_back(worst, to);
  }
  std::sort(bends.begin(), bends.end());
  return bends;
}

}  // namespace

std::vector<std::uint32_t> find_bends(std::span<const Vec2> points, double tolerance) {
  return bends_of(points, tolerance);
}

std::vector<std::uint32_t> find_bends(std::span<const Vec3> points, double tolerance) {
  return bends_of(points, tolerance);
}

}  // namespace quarry
