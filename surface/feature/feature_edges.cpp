#include "surface/feature/feature_edges.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "surface/feature/sharp_chains.hpp"
#include "surface/feature/sharpness.hpp"

namespace quarry {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

SheetJoin ends_of(const TriangleSurface& surface, const SurfaceEdges& edges, std::size_t edge) {
  const auto [a, b] = SurfaceEdges::ends(surface, edges.sides(edge)[0]);
  return join_of(a, b);
}

// How much the surface turns beside an edge of two triangles.
double turn_beside(const SurfaceEdges& edges, const std::vector<double>& angles, std::size_t edge) {
  double turn = 0;
  for (const std::uint32_t side : edges.sides(edge)) {
    const std::uint32_t first = side - side % 3;
    const double one = angles[edges.of_side(first + (side - first + 1) % 3)];
    const double other = angles[edges.of_side(first + (side - first + 2) % 3)];
    turn = std::max(turn, std::min(one, other));
  }
  return turn;
}

// The angles, but for edges within a face: these turn by nothing.
std::vector<double> turns_between_faces(const TriangleSurface& surface, const SurfaceEdges& edges,
                                        std::vector<double> angles, std::span<const SheetJoin> within) {
  if (within.empty()) return angles;
  for (std::size_t e = 0; e < edges.count(); ++e)
    if (std::binary_search(within.begin(), within.end(), ends_of(surface, edges, e))) angles[e] = 0;
  return angles;
}

}  // namespace

FeatureEdges find_feature_edges(const RepairedSurface& repaired, const FeatureOptions& options,
                                std::span<const LineEdge> lines, std::span<const SheetJoin> within) {
  const auto line_of = [&](const SheetJoin& ends) {
    const auto found =
        std::lower_bound(lines.begin(), lines.end(), ends,
                         [](const LineEdge& edge, const SheetJoin& e) { return edge.ends < e; });
    return found != lines.end() && found->ends == ends ? found->line : -1;
  };
  const TriangleSurface& surface = repaired.surface;
  const SurfaceEdges edges(surface);
  const std::vector<double> angles = dihedral_angles(surface, edges);
  const std::vector<double> turns = turns_between_faces(surface, edges, angles, within);
  const double sharp_degrees = options.sharp_degrees.value_or(find_sharpness(surface, edges, turns));
  const double sharp = sharp_degrees * kDegree;
  const double shortest = options.shortest_chain * options.size;
  std::vector<SharpEdge> nearly_sharp;
  std::vector<FeatureEdge> features;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const SheetJoin ends = ends_of(surface, edges, e);
    const auto sides = edges.sides(e);
    const std::int32_t line = line_of(ends);
    if (sides.size() == 1) {
      features.push_back({ends, FeatureKind::kRim, line});
    } else if (std::binary_search(repaired.joins.begin(), repaired.joins.end(), ends)) {
      features.push_back({ends, FeatureKind::kJoin, line});
    } else if (line >= 0) {
      features.push_back({ends, FeatureKind::kLine, line});
    } else if (options.group_borders && surface.groups[sides[0] / 3] != surface.groups[sides[1] / 3]) {
      features.push_back({ends, FeatureKind::kBorder});
    } else if (sharp_degrees < 180 && turns[e] >= options.weakest_share * sharp) {
      // An edge that is a chain by itself is no noise, whatever the edges beside it are: each face of a
      // polyhedron may be a single triangle.
      const double size = length(surface.points[ends[1]] - surface.points[ends[0]]);
      const bool no_noise =
          (shortest > 0 && size >= shortest) || turns[e] >= options.contrast * turn_beside(edges, angles, e);
      nearly_sharp.push_back({ends, turns[e] >= sharp && no_noise});
    }
  }
  std::vector<std::uint8_t> bound(surface.points.size(), 0);
  for (const FeatureEdge& feature : features)
    for (const std::uint32_t p : feature.ends) bound[p] = 1;
  for (const SharpEdge& edge : keep_long_chains(surface.points, std::move(nearly_sharp), bound, shortest))
    features.push_back({edge.ends, FeatureKind::kSharp});
  std::sort(features.begin(), features.end(),
            [](const FeatureEdge& a, const FeatureEdge& b) { return a.ends < b.ends; });
  return {std::move(features), sharp_degrees};
}

}  // namespace quarry
