#include "bench/synthetic_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/random.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/domain.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/initial/crisscross.hpp"
#include "kernels/linework/outline.hpp"

namespace quarry::bench {
namespace {

constexpr double kSide = 1000;
constexpr Vec2 kCorner{466000, 6691000};
constexpr int kBends = 4;

// Lengths follow n(l) ~ l^-2.5, as those of fractures do; the shortest makes lines about their own length
// apart.
InputLine draw_line(std::uint64_t number, double shortest) {
  const auto lot = [&](std::uint64_t stream) { return uniform01(stream, number); };
  const double length = std::min(0.5 * kSide, shortest * std::pow(1 - lot(0), -1 / 1.5));
  const double direction = (lot(1) < 0.6 ? 0.35 : 1.66) + 0.3 * (lot(2) - 0.5);
  const Vec2 along{std::cos(direction), std::sin(direction)};
  const Vec2 across{-along.y, along.x};
  const Vec2 middle{kCorner.x + kSide * lot(3), kCorner.y + kSide * lot(4)};
  InputLine line;
  for (int i = 0; i <= kBends; ++i) {
    const double t = static_cast<double>(i) / kBends - 0.5;
    const double off = 0.03 * length * (lot(5 + static_cast<std::uint64_t>(i)) - 0.5);
    const Vec2 p = middle + (t * length) * along + off * across;
    line.points.push_back(
        {std::clamp(p.x, kCorner.x, kCorner.x + kSide), std::clamp(p.y, kCorner.y, kCorner.y + kSide)});
  }
  return line;
}

}  // namespace

LineSet draw_network(std::uint32_t lines) {
  LineSet set;
  set.files = {"drawn by lot"};
  const double shortest = 0.7 * kSide / std::sqrt(static_cast<double>(lines));
  for (std::uint32_t i = 0; i < lines; ++i) set.lines.push_back(draw_line(i, shortest));
  return set;
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
