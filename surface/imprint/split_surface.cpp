#include "surface/imprint/split_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace quarry {
namespace {

// Of a point in the plane of a triangle: the doubled areas opposite to its corners by that of the triangle.
std::array<double, 3> weights_in(const std::array<Vec3, 3>& p, Vec3 place) {
  const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
  const double squared = dot(n, n);
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = p[(k + 1) % 3], b = p[(k + 2) % 3];
    weights[k] = squared > 0 ? dot(cross(a - place, b - place), n) / squared
                             : -std::numeric_limits<double>::infinity();
  }
  return weights;
}

// The foot on the segment a-b, as a share of it, within it.
double share_along(Vec3 a, Vec3 b, Vec3 place) {
  const Vec3 d = b - a;
  const double squared = dot(d, d);
  return squared > 0 ? std::clamp(dot(place - a, d) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

SplitSurface::SplitSurface(RepairedSurface& repaired)
    : repaired_(repaired),
      surface_(repaired.surface),
      around_(surface_.points.size()),
      first_(surface_.triangles.size()),
      joins_(repaired.joins.begin(), repaired.joins.end()) {
  std::iota(first_.begin(), first_.end(), 0U);
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
    for (const std::uint32_t p : surface_.triangles[t]) around_[p].push_back(t);
}

void SplitSurface::finish() { repaired_.joins.assign(joins_.begin(), joins_.end()); }

bool SplitSurface::has_edge(std::uint32_t a, std::uint32_t b) const {
  return std::any_of(around_[a].begin(), around_[a].end(), [&](std::uint32_t t) {
    const SurfaceTriangle& corners = surface_.triangles[t];
    return std::find(corners.begin(), corners.end(), b) != corners.end();
  });
}

std::uint32_t SplitSurface::add_point(Vec3 place) {
  surface_.points.push_back(place);
  around_.emplace_back();
  return static_cast<std::uint32_t>(surface_.points.size() - 1);
}

void SplitSurface::add_part(std::uint32_t of, SurfaceTriangle corners) {
  const auto part = static_cast<std::uint32_t>(surface_.triangles.size());
  surface_.triangles.push_back(corners);
  surface_.groups.push_back(surface_.groups[of]);
  first_.push_back(first_[of]);
  auto& parts = parts_[first_[of]];
  if (parts.empty()) parts.push_back(first_[of]);
  parts.push_back(part);
  for (const std::uint32_t p : corners) around_[p].push_back(part);
}

void SplitSurface::replace(std::uint32_t triangle, SurfaceTriangle corners) {
  for (const std::uint32_t p : surface_.triangles[triangle])
    if (std::find(corners.begin(), corners.end(), p) == corners.end()) std::erase(around_[p], triangle);
  for (const std::uint32_t p : corners)
    if (std::find(around_[p].begin(), around_[p].end(), triangle) == around_[p].end())
      around_[p].push_back(triangle);
  surface_.triangles[triangle] = corners;
}

std::uint32_t SplitSurface::split_edge(std::uint32_t a, std::uint32_t b, Vec3 place) {
  const std::uint32_t middle = add_point(place);
  const std::vector<std::uint32_t> at_a = around_[a];
  for (const std::uint32_t t : at_a) {
    const SurfaceTriangle corners = surface_.triangles[t];
    if (std::find(corners.begin(), corners.end(), b) == corners.end()) continue;
    SurfaceTriangle with_a = corners, with_b = corners;
    std::replace(with_a.begin(), with_a.end(), b, middle);
    std::replace(with_b.begin(), with_b.end(), a, middle);
    replace(t, with_a);
    add_part(t, with_b);
  }
  const SheetJoin whole = join_of(a, b);
  if (joins_.erase(whole) > 0) {
    joins_.insert(join_of(a, middle));
    joins_.insert(join_of(middle, b));
  }
  if (const auto found = marks_.find(whole); found != marks_.end()) {
    const std::int32_t number = found->second;
    marks_.erase(found);
    mark(a, middle, number);
    mark(middle, b, number);
  }
  return middle;
}

std::uint32_t SplitSurface::split_face(std::uint32_t triangle, Vec3 place) {
  const std::uint32_t middle = add_point(place);
  const auto [a, b, c] = surface_.triangles[triangle];
  replace(triangle, {a, b, middle});
  add_part(triangle, {b, c, middle});
  add_part(triangle, {c, a, middle});
  return middle;
}

// The part of a triangle in which a place lies, or is least outside.
std::uint32_t SplitSurface::part_at(std::uint32_t first_triangle, Vec3 place) const {
  const auto found = parts_.find(first_triangle);
  if (found == parts_.end()) return first_triangle;
  std::uint32_t best = first_triangle;
  double most = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : found->second) {
    const SurfaceTriangle& corners = surface_.triangles[t];
    const auto w = weights_in({point(corners[0]), point(corners[1]), point(corners[2])}, place);
    const double inside = std::min({w[0], w[1], w[2]});
    if (!(inside > most)) continue;
    most = inside;
    best = t;
  }
  return best;
}

std::uint32_t SplitSurface::point_at(std::uint32_t first_triangle, Vec3 place, double snap) {
  const std::uint32_t t = part_at(first_triangle, place);
  const SurfaceTriangle corners = surface_.triangles[t];
  std::uint32_t nearest = corners[0];
  for (const std::uint32_t p : corners)
    if (length(point(p) - place) < length(point(nearest) - place)) nearest = p;
  if (length(point(nearest) - place) <= snap) return nearest;
  std::size_t side = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = point(corners[k]), b = point(corners[(k + 1) % 3]);
    const double away = length(a + share_along(a, b, place) * (b - a) - place);
    if (away < least) side = k;
    least = std::min(least, away);
  }
  const Vec3 a = point(corners[side]), b = point(corners[(side + 1) % 3]);
  const double share = share_along(a, b, place);
  if (least > snap) return split_face(t, place);
  // An end of the edge is farther than the snapping distance: the foot lies within it.
  return split_edge(corners[side], corners[(side + 1) % 3], a + share * (b - a));
}

}  // namespace quarry
