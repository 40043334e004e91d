#include "surface/repair/fill_holes.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

// The open side that follows an open side on its rim: turns around the end of the side through the fan of its
// triangle.
std::uint32_t next_open_side(const TriangleSurface& surface, const SurfaceEdges& edges, std::uint32_t side) {
  const auto after = [](std::uint32_t s) { return s - s % 3 + (s + 1) % 3; };
  std::uint32_t at = after(side);
  // At most every triangle once: a fan that meets a branch or a seam ends there.
  for (std::size_t turns = 0; turns <= surface.triangles.size(); ++turns) {
    const auto sides = edges.sides(edges.of_side(at));
    if (sides.size() != 2) return at;
    const std::uint32_t across = sides[0] == at ? sides[1] : sides[0];
    if (SurfaceEdges::ends(surface, across).first == SurfaceEdges::ends(surface, at).first) return at;
    at = after(across);
  }
  return at;
}

// The cheapest triangulation of a polygon: cost[i][j] of the part between its corners i and j.
class PolygonFill {
 public:
  PolygonFill(const TriangleSurface& surface, const std::vector<std::uint32_t>& rim,
              const std::set<std::pair<std::uint32_t, std::uint32_t>>& taken)
      : surface_(surface), rim_(rim), taken_(taken), n_(rim.size()) {
    cost_.assign(n_ * n_, 0);
    apex_.assign(n_ * n_, 0);
    for (std::size_t span = 2; span < n_; ++span)
      for (std::size_t i = 0; i + span < n_; ++i) solve(i, i + span);
  }

  [[nodiscard]] bool possible() const { return cost_[n_ - 1] < std::numeric_limits<double>::infinity(); }
  void collect(std::size_t i, std::size_t j, std::vector<SurfaceTriangle>& triangles) const {
    if (j - i < 2) return;
    const std::size_t k = apex_[i * n_ + j];
    collect(i, k, triangles);
    collect(k, j, triangles);
    // The rim runs with its triangles: the fill runs against it.
    triangles.push_back({rim_[j], rim_[k], rim_[i]});
  }

 private:
  void solve(std::size_t i, std::size_t j) {
    double& best = cost_[i * n_ + j];
    best = std::numeric_limits<double>::infinity();
    const bool closing = i == 0 && j == n_ - 1;  // an edge of the rim itself
    if (rim_[i] == rim_[j] || (!closing && taken_.contains(std::minmax(rim_[i], rim_[j])))) return;
    for (std::size_t k = i + 1; k < j; ++k) {
      const double area = length(doubled_area(surface_, {rim_[j], rim_[k], rim_[i]}));
      const double cost = cost_[i * n_ + k] + cost_[k * n_ + j] + area;
      if (cost >= best) continue;
      best = cost;
      apex_[i * n_ + j] = k;
    }
  }

  const TriangleSurface& surface_;
  const std::vector<std::uint32_t>& rim_;
  const std::set<std::pair<std::uint32_t, std::uint32_t>>& taken_;
  std::size_t n_;
  std::vector<double> cost_;
  std::vector<std::size_t> apex_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> rims_of(const TriangleSurface& surface) {
  const SurfaceEdges edges(surface);
  std::vector<std::uint8_t> seen(3 * surface.triangles.size(), 0);
  std::vector<std::vector<std::uint32_t>> rims;
  for (std::uint32_t first = 0; first < seen.size(); ++first) {
    std::vector<std::uint32_t> rim;
    std::uint32_t side = first;
    while (seen[side] == 0 && edges.sides(edges.of_side(side)).size() == 1) {
      seen[side] = 1;
      rim.push_back(SurfaceEdges::ends(surface, side).first);
      side = next_open_side(surface, edges, side);
    }
    // A course that ends at a branch is no hole.
    if (rim.empty() || side != first) continue;
    std::rotate(rim.begin(), std::min_element(rim.begin(), rim.end()), rim.end());
    rims.push_back(std::move(rim));
  }
  return rims;
}

std::vector<FilledHole> fill_holes(const TriangleSurface& surface, std::uint32_t most_edges) {
  const SurfaceEdges edges(surface);
  std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
  std::vector<std::int32_t> group_at(surface.points.size(), 0);
  for (std::uint32_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = SurfaceEdges::ends(surface, edges.sides(e)[0]);
    taken.insert(std::minmax(a, b));
    if (edges.sides(e).size() == 1) group_at[a] = surface.groups[edges.sides(e)[0] / 3];
  }
  std::vector<FilledHole> holes;
  for (std::vector<std::uint32_t>& rim : rims_of(surface)) {
    if (rim.size() > most_edges) continue;
    const PolygonFill fill(surface, rim, taken);
    if (!fill.possible()) continue;
    FilledHole hole;
    fill.collect(0, rim.size() - 1, hole.triangles);
    hole.group = group_at[rim.front()];
    hole.rim = std::move(rim);
    for (const SurfaceTriangle& t : hole.triangles)
      for (std::size_t k = 0; k < 3; ++k) taken.insert(std::minmax(t[k], t[(k + 1) % 3]));
    holes.push_back(std::move(hole));
  }
  return holes;
}

}  // namespace quarry
