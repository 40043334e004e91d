#include "io/mesh/grouped_entities.hpp"

#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

// Two signed numbers as one unsigned key in their order.
std::uint64_t key_of(std::int32_t high, std::int32_t low) {
  constexpr std::uint32_t kSign = 0x80000000U;
  return (std::uint64_t{static_cast<std::uint32_t>(high) ^ kSign} << 32) |
         (static_cast<std::uint32_t>(low) ^ kSign);
}

void group_faces(const Mesh& mesh, const LiveNumbering& numbering, const MeshFileTags& tags,
                 GroupedEntities& grouped) {
  std::vector<std::uint64_t> keys(numbering.face_count());
  for (std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = key_of(tags.region(numbering.face(i)), mesh.corner_count(numbering.face(i)));
  grouped.faces.reserve(keys.size());
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys))) {
    const FaceId f = numbering.face(i);
    const FaceGroup group{tags.region(f), mesh.corner_count(f), grouped.faces.size(), grouped.faces.size()};
    if (grouped.face_groups.empty() || grouped.face_groups.back().region != group.region ||
        grouped.face_groups.back().corners != group.corners)
      grouped.face_groups.push_back(group);
    grouped.faces.push_back(f);
    grouped.face_groups.back().end = grouped.faces.size();
  }
}

void group_edges(const LiveNumbering& numbering, const MeshFileTags& tags, GroupedEntities& grouped) {
  std::vector<std::uint64_t> keys;
  // Kinds are few and not below 0.
  constexpr std::int32_t kKinds = 1 << 16;
  for (const EdgeId e : numbering.edges())
    keys.push_back(key_of(tags.constraint(e), tags.side(e) * kKinds + tags.kind(e)));
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys))) {
    const EdgeId e = numbering.edges()[i];
    const EdgeGroup group{tags.constraint(e), tags.kind(e), tags.side(e), grouped.edges.size(),
                          grouped.edges.size()};
    if (grouped.edge_groups.empty() || grouped.edge_groups.back().constraint != group.constraint ||
        grouped.edge_groups.back().kind != group.kind || grouped.edge_groups.back().side != group.side)
      grouped.edge_groups.push_back(group);
    grouped.edges.push_back(e);
    grouped.edge_places.push_back(i);
    grouped.edge_groups.back().end = grouped.edges.size();
  }
}

}  // namespace

GroupedEntities group_entities(const Mesh& mesh, const LiveNumbering& numbering) {
  const MeshFileTags tags(mesh);
  GroupedEntities grouped;
  group_faces(mesh, numbering, tags, grouped);
  group_edges(numbering, tags, grouped);
  return grouped;
}

}  // namespace quarry
