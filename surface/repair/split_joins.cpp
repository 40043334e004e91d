#include "surface/repair/split_joins.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

// Halves an edge at a new point, and each triangle that has it.
void halve(RepairedSurface& repaired, std::span<const std::uint32_t> sides, std::vector<SheetJoin>& joins) {
  TriangleSurface& surface = repaired.surface;
  const auto [a, b] = SurfaceEdges::ends(surface, sides[0]);
  const auto middle = static_cast<std::uint32_t>(surface.points.size());
  surface.points.push_back(0.5 * (surface.points[a] + surface.points[b]));
  joins.push_back(join_of(a, middle));
  joins.push_back(join_of(middle, b));
  for (const std::uint32_t side : sides) {
    const SurfaceTriangle t = surface.triangles[side / 3];
    const std::uint32_t k = side % 3;
    surface.triangles[side / 3] = {t[k], middle, t[(k + 2) % 3]};
    surface.triangles.push_back({middle, t[(k + 1) % 3], t[(k + 2) % 3]});
    surface.groups.push_back(surface.groups[side / 3]);
  }
}

// One round: of those that are wanted the ones that share no triangle with one before them. True if there was
// one.
template <class Wanted>
bool halve_apart(RepairedSurface& repaired, const Wanted& wanted) {
  const SurfaceEdges edges(repaired.surface);
  std::vector<std::uint8_t> taken(repaired.surface.triangles.size(), 0);
  std::vector<SheetJoin> joins, halved;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto sides = edges.sides(e);
    // The triangles of an edge that is still whole are those of the beginning of the round.
    if (std::any_of(sides.begin(), sides.end(), [&](std::uint32_t s) { return taken[s / 3] != 0; })) continue;
    const auto [a, b] = SurfaceEdges::ends(repaired.surface, sides[0]);
    const SheetJoin join = join_of(a, b);
    if (!std::binary_search(repaired.joins.begin(), repaired.joins.end(), join) || !wanted(join)) continue;
    for (const std::uint32_t s : sides) taken[s / 3] = 1;
    halved.push_back(join);
    halve(repaired, sides, joins);
  }
  std::sort(halved.begin(), halved.end());
  std::set_difference(repaired.joins.begin(), repaired.joins.end(), halved.begin(), halved.end(),
                      std::back_inserter(joins));
  repaired.joins = std::move(joins);
  std::sort(repaired.joins.begin(), repaired.joins.end());
  return !halved.empty();
}

}  // namespace

void split_joins(RepairedSurface& repaired, double longest) {
  const auto too_long = [&](const SheetJoin& join) {
    return length(repaired.surface.points[join[1]] - repaired.surface.points[join[0]]) > longest;
  };
  // Each round halves at least the first join that is too long: ends when all are short.
  while (halve_apart(repaired, too_long)) {
  }
}

void halve_joins(RepairedSurface& repaired) {
  const std::vector<SheetJoin> whole = repaired.joins;
  const auto is_whole = [&](const SheetJoin& join) {
    return std::binary_search(whole.begin(), whole.end(), join);
  };
  while (halve_apart(repaired, is_whole)) {
  }
}

}  // namespace quarry
