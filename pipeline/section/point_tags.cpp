#include "pipeline/section/point_tags.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/constraint.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

void tag_points(Mesh& mesh, const CleanedLines& cleaned) {
  if (cleaned.points.empty()) return;
  IdVector<NodeId, std::int32_t> point_at(cleaned.lines.nodes.size(), -1);
  for (std::size_t i = cleaned.points.size(); i-- > 0;)
    if (const NodeId node = cleaned.points[PointId(i)].node; node.valid())
      point_at[node] = static_cast<std::int32_t>(i);
  auto tag = mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1);
  const ConstraintTags tags = ConstraintTags::of(mesh);
  IdVector<NodeId, std::uint8_t> found(point_at.size());
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v) || !tags.support[v].is_node()) continue;
    const NodeId node = tags.support[v].node();
    if (!(mesh.point(v) == cleaned.lines.nodes[node])) continue;
    tag[v] = point_at[node];
    found[node] = 1;
  }
  for (const NodeId node : IdRange<NodeId>(found.size())) {
    if (point_at[node] < 0 || found[node] != 0) continue;
    const Vec2 p = cleaned.lines.nodes[node];
    throw Error(ErrorKind::kBug, fmt::format("point {} of the input, at {}, has no vertex", point_at[node],
                                             format_point(p.x, p.y)));
  }
}

std::map<std::int32_t, std::string> point_names(const LineSet& lines) {
  std::map<std::string, std::int32_t> uses;
  for (const PointId id : IdRange<PointId>(lines.points.size())) ++uses[lines.attributes_of(id).name];
  std::map<std::int32_t, std::string> names;
  for (const PointId id : IdRange<PointId>(lines.points.size()))
    if (const std::string name = lines.attributes_of(id).name; !name.empty() && uses[name] == 1)
      names[static_cast<std::int32_t>(id.value())] = name;
  return names;
}

}  // namespace quarry
