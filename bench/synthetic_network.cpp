#include "bench/synthetic_network.hpp"

#include <utility>

#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/domain.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/initial/crisscross.hpp"
#include "kernels/linework/outline.hpp"
#include "pipeline/generate/fractures.hpp"

namespace quarry::bench {
LineSet draw_network(std::uint32_t lines, bool curved) {
  constexpr Vec2 kCorner{466000, 6691000};
  constexpr Vec2 kSides{1000, 1000};
  FractureOptions options;
  options.box = {kCorner, kCorner + kSides};
  options.count = lines;
  options.curved = curved;
  return generate_fractures(options, {}).lines;
}

CleanedLines clean_network(std::uint32_t lines, double size) {
  const LineSet set = draw_network(lines);
  const CleanOptions options{.snap = 0.05 * size, .min_edge = 0.1 * size, .tolerance = 0.05 * size};
  return clean_lines(set, box_outline(set, options.snap), options);
}

Mesh start_mesh(const NodedLines& lines, double size) {
  Box2 box;
  for (const Vec2 node : lines.nodes) box.extend(node);
  Mesh mesh = make_crisscross(box, {.cell = 2 * size});
  auto tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  return mesh;
}

Mesh triangle_mesh(const NodedLines& lines, double size) {
  Mesh mesh = start_mesh(lines, size);
  DeferredOptions options;
  options.spacing = 2 * size;
  DeferredReport report;
  (void)insert_lines(mesh, lines, options, report, {});
  remove_outside(mesh, ConstraintTags::of(mesh), lines);
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

Mesh raw_quad_mesh(const NodedLines& lines, double size) {
  Mesh mesh = triangle_mesh(lines, size);
  PairingReport paired;
  const Pairing pairing = pair_triangles(mesh, ConstraintTags::of(mesh), {}, paired, {});
  SubdivideReport halved;
  return subdivide(merge_pairs(std::move(mesh), pairing), lines, halved, {});
}

}  // namespace quarry::bench
