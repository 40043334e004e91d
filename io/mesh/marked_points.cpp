#include "io/mesh/marked_points.hpp"

#include <algorithm>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

std::vector<MarkedPoint> marked_points(const Mesh& mesh, const LiveNumbering& numbering) {
  std::vector<MarkedPoint> marked;
  const auto tag = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  if (!tag.valid()) return marked;
  for (std::size_t i = 0; i < numbering.vertex_count(); ++i)
    if (const std::int32_t point = tag[numbering.vertex(i)]; point >= 0)
      marked.push_back({point, static_cast<std::uint32_t>(i)});
  std::ranges::stable_sort(marked, {}, &MarkedPoint::point);
  return marked;
}

}  // namespace quarry
