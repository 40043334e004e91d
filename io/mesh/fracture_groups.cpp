#include "io/mesh/fracture_groups.hpp"

#include <map>
#include <utility>

#include "io/mesh/group_name.hpp"
#include "io/mesh/single_edges.hpp"

namespace quarry {

FractureGroups fracture_groups(const Mesh& mesh, const LiveNumbering& numbering,
                               const GroupedEntities& grouped, const GroupNames& names) {
  const MeshFileTags tags(mesh);
  FractureGroups groups;
  std::vector<std::uint32_t> boundary = single_edges(mesh, numbering);
  std::erase_if(boundary, [&](std::uint32_t i) { return tags.kind(numbering.edges()[i]) != kOuterBoundary; });
  if (!boundary.empty()) groups.side_sets.push_back({std::string(kOuterBoundaryName), std::move(boundary)});
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::uint32_t>> lines;
  for (const EdgeGroup& group : grouped.edge_groups) {
    if (group.constraint < 0 && group.kind == kOuterBoundary) continue;
    std::vector<std::uint32_t>& line = lines[{group.constraint, group.side}];
    for (std::size_t i = group.begin; i < group.end; ++i) line.push_back(grouped.edge_places[i]);
  }
  for (auto& [line, edges] : lines)
    groups.side_sets.push_back({line_side_name(line.first, line.second, names), std::move(edges)});
  std::map<std::int32_t, std::vector<std::uint32_t>> blocks;
  for (const std::uint32_t i : fracture_edges(mesh, numbering))
    blocks[tags.constraint(numbering.edges()[i])].push_back(i);
  for (auto& [line, edges] : blocks) groups.blocks.push_back({line_name(line, names), std::move(edges)});
  return groups;
}

}  // namespace quarry
