#include "io/mesh/msh_curves.hpp"

#include <span>
#include <utility>

#include "io/mesh/group_name.hpp"

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

MshCurves curves_by_line(const GroupedEntities& grouped, const GroupNames& names,
                         const LineGroupNames& line_groups) {
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
  const std::size_t first = result.names.size() + 1;
  result.names.insert(result.names.end(), line_groups.all().begin(), line_groups.all().end());
  for (std::size_t i = 0; i < result.curves.size(); ++i)
    // All edges of a line are in the same groups.
    for (const std::size_t group : line_groups.of(grouped.edges[grouped.edge_groups[i].begin]))
      result.curves[i].groups.push_back(first + group);
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
