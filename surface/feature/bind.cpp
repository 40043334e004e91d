#include "surface/feature/bind.hpp"

#include <algorithm>

#include "engine/parallel/parallel.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry {

ConstraintTags bind_features(Mesh& sheets, const CurveNetwork& network) {
  ConstraintTags tags = ConstraintTags::add_to(sheets);
  const auto point_of = sheets.find_tag<VertexId, std::uint32_t>(kSurfacePointTag);
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<Support> support(sheets.vertex_slots());
  for (const PieceId curve : IdRange<PieceId>(network.curves.size())) {
    const std::vector<std::uint32_t>& points = network.curves[curve].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      edges.push_back({std::min(points[i], points[i + 1]), std::max(points[i], points[i + 1])});
      support[points[i]] = Support::on(curve);
    }
  }
  for (const NodeId node : IdRange<NodeId>(network.nodes.size()))
    support[network.nodes[node]] = Support::at(node);
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> fans(sheets.vertex_slots(), 0);
  for (const VertexId v : sheets.vertices())
    if (sheets.alive(v)) ++fans[point_of[v]];
  parallel::for_each(sheets.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    const std::uint32_t point = point_of[v];
    tags.support[v] = fans[point] > 1 && !support[point].is_node() ? Support::fixed() : support[point];
  });
  parallel::for_each(sheets.face_slots(), [&](std::size_t f) {
    for (int k = 0; k < sheets.corner_count(FaceId(f)); ++k) {
      const SideId s(FaceId(f), k);
      const std::uint32_t a = point_of[sheets.origin(s)];
      const std::uint32_t b = point_of[sheets.target(s)];
      if (std::binary_search(edges.begin(), edges.end(), std::array{std::min(a, b), std::max(a, b)}))
        tags.set_constrained(s, true);
    }
  });
  return tags;
}

void fix_rims(const Mesh& sheets, ConstraintTags tags) {
  parallel::for_each(sheets.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (sheets.alive(v) && sheets.on_boundary(v) && tags.support[v].slides())
      tags.support[v] = Support::fixed();
  });
}

}  // namespace quarry
