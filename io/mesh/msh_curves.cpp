#include "io/mesh/msh_curves.hpp"

#include <map>
#include <utility>

#include "io/mesh/group_name.hpp"

namespace quarry {
namespace {

// The group of the line, or side of one, that a group of edges belongs to; groups of edges come in their
// order.
std::size_t line_group(const EdgeGroup& group, const EdgeGroup* before, const GroupNames& names,
                       MshCurves& result) {
  if (before == nullptr || before->constraint != group.constraint || before->side != group.side)
    result.names.push_back(line_side_name(group.constraint, group.side, names));
  return result.names.size();
}

}  // namespace

MshCurves curves_by_line(const GroupedEntities& grouped, const GroupNames& names,
                         const ExtraGroups<EdgeId>& extra_groups) {
  MshCurves result;
  result.names.emplace_back(kOuterBoundaryName);
  const EdgeGroup* before = nullptr;
  std::vector<std::vector<std::size_t>> extra_of_curve;
  for (const EdgeGroup& group : grouped.edge_groups) {
    const std::size_t line = line_group(group, before, names, result);
    before = &group;
    MshCurve curve;
    if (group.kind == kOuterBoundary) curve.groups.push_back(1);
    if (group.constraint >= 0 || group.kind != kOuterBoundary) curve.groups.push_back(line);
    // All edges of a curve are in the same groups: the sides of a box are curves of their own.
    std::map<std::vector<std::size_t>, std::vector<std::uint32_t>> parts;
    for (std::size_t i = group.begin; i < group.end; ++i)
      parts[extra_groups.of(grouped.edges[i])].push_back(grouped.edge_places[i]);
    for (auto& [groups, edges] : parts) {
      result.curves.push_back({curve.groups, std::move(edges)});
      extra_of_curve.push_back(groups);
    }
  }
  const std::size_t first = result.names.size() + 1;
  result.names.insert(result.names.end(), extra_groups.all().begin(), extra_groups.all().end());
  for (std::size_t i = 0; i < result.curves.size(); ++i)
    for (const std::size_t group : extra_of_curve[i]) result.curves[i].groups.push_back(first + group);
  return result;
}

MshCurves curves_for_moose(const FractureGroups& groups) {
  MshCurves result;
  const auto add_curve = [&](std::string name, const std::vector<std::uint32_t>& edges) {
    result.names.push_back(std::move(name));
    result.curves.push_back({{result.names.size()}, edges});
  };
  for (const NamedEdges& set : groups.side_sets) add_curve(set.name, set.edges);
  for (const NamedEdges& block : groups.blocks)
    add_curve(block.name + "_lower_dimensional_block", block.edges);
  result.surface_offset = result.names.size();
  return result;
}

}  // namespace quarry
