#include "io/mesh/single_edges.hpp"

#include <algorithm>
#include <tuple>

namespace quarry {

std::vector<std::uint32_t> single_edges(const Mesh& mesh, const LiveNumbering& numbering) {
  const MeshFileTags tags(mesh);
  std::vector<std::tuple<VertexId, VertexId, std::int32_t, std::uint32_t>> items;
  for (std::size_t i = 0; i < numbering.edges().size(); ++i) {
    const EdgeId e = numbering.edges()[i];
    const auto [a, b] = mesh.edge_ends(e);
    items.emplace_back(std::min(a, b), std::max(a, b), tags.constraint(e), static_cast<std::uint32_t>(i));
  }
  std::sort(items.begin(), items.end());
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (i == 0 || std::get<0>(items[i]) != std::get<0>(items[i - 1]) ||
        std::get<1>(items[i]) != std::get<1>(items[i - 1]))
      places.push_back(std::get<3>(items[i]));
  std::sort(places.begin(), places.end());
  return places;
}

std::vector<std::uint32_t> fracture_edges(const Mesh& mesh, const LiveNumbering& numbering) {
  const MeshFileTags tags(mesh);
  std::vector<std::uint32_t> places = single_edges(mesh, numbering);
  std::erase_if(places, [&](std::uint32_t i) {
    const EdgeId e = numbering.edges()[i];
    return tags.kind(e) != kInteriorConstraint || tags.side(e) == kRightSide;
  });
  return places;
}

}  // namespace quarry
