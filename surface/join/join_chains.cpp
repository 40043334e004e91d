#include "surface/join/join_chains.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

// By point, whether joins end there: where other than two meet, or at an edge that is no join and where the
// surface does not go on from one triangle to another of its group.
std::vector<std::uint8_t> ends_of_joins(const RepairedSurface& repaired) {
  const TriangleSurface& surface = repaired.surface;
  std::vector<std::uint8_t> node(surface.points.size(), 0);
  std::vector<std::uint32_t> joins(surface.points.size(), 0);
  for (const SheetJoin& join : repaired.joins)
    for (const std::uint32_t p : join) ++joins[p];
  for (std::size_t p = 0; p < node.size(); ++p) node[p] = joins[p] != 0 && joins[p] != 2 ? 1 : 0;
  const SurfaceEdges edges(surface);
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const std::span<const std::uint32_t> sides = edges.sides(e);
    const auto [a, b] = SurfaceEdges::ends(surface, sides[0]);
    const bool goes_on = sides.size() == 2 && surface.groups[sides[0] / 3] == surface.groups[sides[1] / 3];
    if (!goes_on && !std::binary_search(repaired.joins.begin(), repaired.joins.end(), join_of(a, b)))
      node[a] = node[b] = 1;
  }
  return node;
}

}  // namespace

std::vector<EdgeChain> join_chains(const RepairedSurface& repaired, const FeatureOptions& corners) {
  std::vector<std::uint8_t> node = ends_of_joins(repaired);
  std::vector<std::uint32_t> found;
  for (const EdgeChain& chain : edge_chains(repaired.joins, node)) {
    std::vector<Vec3> places;
    for (const std::uint32_t p : chain.points) places.push_back(repaired.surface.points[p]);
    for (const std::uint32_t corner : find_corners(places, chain.ends, corners))
      found.push_back(chain.points[corner]);
  }
  for (const std::uint32_t p : found) node[p] = 1;
  return edge_chains(repaired.joins, node);
}

}  // namespace quarry
