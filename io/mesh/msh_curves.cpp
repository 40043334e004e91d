#include "io/mesh/msh_curves.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "io/mesh/group_name.hpp"
#include "io/mesh/single_edges.hpp"

namespace quarry {
namespace {

std::span<const std::uint32_t> edges_of(const GroupedEntities& grouped, const EdgeGroup& group) {
  return std::span(grouped.edge_places).subspan(group.begin, group.end - group.begin);
}

// The group of the line, or side of one, that a group of edges belongs to; groups of edges come in their
// order.
std::size_t line_group(const EdgeGroup& group, const EdgeGroup* before, const GroupNames& names,
                       MshCurves& result) {
  if (before == nullptr || before->constraint != group.constraint || before->side != group.side)
    result.names.push_back(line_side_name(group.constraint, group.side, names));
  return result.names.size();
}

}  // namespace

MshCurves curves_by_line(const GroupedEntities& grouped, const GroupNames& names) {
  MshCurves result;
  result.names.emplace_back(kOuterBoundaryName);
  const EdgeGroup* before = nullptr;
  for (const EdgeGroup& group : grouped.edge_groups) {
    const std::size_t line = line_group(group, before, names, result);
    before = &group;
    MshCurve curve;
    if (group.kind == kOuterBoundary) curve.groups.push_back(1);
    if (group.constraint >= 0 || group.kind != kOuterBoundary) curve.groups.push_back(line);
    const auto edges = edges_of(grouped, group);
    curve.edges.assign(edges.begin(), edges.end());
    result.curves.push_back(std::move(curve));
  }
  return result;
}

MshCurves curves_for_moose(const Mesh& mesh, const LiveNumbering& numbering, const GroupedEntities& grouped,
                           const GroupNames& names) {
  MshCurves result;
  const MeshFileTags tags(mesh);
  const auto add_curve = [&](std::string name, std::vector<std::uint32_t> edges) {
    if (edges.empty()) return;
    result.names.push_back(std::move(name));
    result.curves.push_back({{result.names.size()}, std::move(edges)});
  };
  std::vector<std::uint32_t> boundary = single_edges(mesh, numbering);
  std::erase_if(boundary, [&](std::uint32_t i) { return tags.kind(numbering.edges()[i]) != kOuterBoundary; });
  add_curve(std::string(kOuterBoundaryName), std::move(boundary));
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::uint32_t>> lines;
  for (const EdgeGroup& group : grouped.edge_groups) {
    if (group.constraint < 0 && group.kind == kOuterBoundary) continue;
    std::vector<std::uint32_t>& line = lines[{group.constraint, group.side}];
    const auto edges = edges_of(grouped, group);
    line.insert(line.end(), edges.begin(), edges.end());
  }
  for (auto& [line, edges] : lines)
    add_curve(line_side_name(line.first, line.second, names), std::move(edges));
  std::map<std::int32_t, std::vector<std::uint32_t>> blocks;
  for (const std::uint32_t i : fracture_edges(mesh, numbering))
    blocks[tags.constraint(numbering.edges()[i])].push_back(i);
  for (auto& [line, edges] : blocks)
    add_curve(line_name(line, names) + "_lower_dimensional_block", std::move(edges));
  result.surface_offset = result.names.size();
  return result;
}

}  // namespace quarry
