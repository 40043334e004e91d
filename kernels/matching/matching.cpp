#include "kernels/matching/matching.hpp"

#include <cassert>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/balance.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/local/better_flips.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/quad_shape.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/subtree_parity.hpp"

namespace quarry {
namespace {

void better_triangles(Mesh& mesh, const NodedLines& lines, const MatchingOptions& options,
                      MatchingReport& report, const Progress& progress) {
  if (!options.better_triangles) return;
  report.flips = flip_to_better(mesh, progress);
  report.smoothing.push_back(smooth_laplacian(mesh, lines, options.smoothing, progress));
}

// Every triangle is merged with one neighbour, or split among three.
[[maybe_unused]] bool is_join(const Mesh& mesh, const DualArcs& join) {
  return parallel::filter_indices(mesh.face_slots(),
                                  [&](std::size_t i) {
                                    return mesh.alive(FaceId(i)) &&
                                           matching::degree(join[FaceId(i)]) % 2 == 0;
                                  })
      .empty();
}

[[maybe_unused]] bool has_even_regions(const Mesh& mesh, ConstraintTags tags) {
  return count_odd_regions(mesh, maximum_spanning_forest(mesh, pair_shapes(mesh, tags)).root) == 0;
}

std::vector<std::uint32_t> invalid_faces(const Mesh& mesh) {
  return parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    return mesh.alive(FaceId(i)) && !matching::is_convex(mesh, FaceId(i));
  });
}

void smooth(Mesh& mesh, const NodedLines& lines, const MatchingOptions& options, MatchingReport& report,
            const Progress& progress) {
  const BalanceGuard balance(mesh);
  for (int round = 0; round < options.opening_rounds; ++round) {
    progress.report("smoothing", static_cast<double>(round) / (options.opening_rounds + 1));
    report.smoothing.push_back(optimise_shape(mesh, lines, options.shape, progress));
    report.openings.push_back(open_straight_corners(mesh, options.openings, progress));
    balance.check("openings", mesh, GeometryCheck::kNone);
  }
  report.smoothing.push_back(optimise_shape(mesh, lines, options.shape, progress));
  for (int round = 0; round < options.ring_rounds; ++round) {
    report.rings.push_back(
        ring_straight_corners(mesh, lines, {.keep_boundary = options.keep_boundary}, progress));
    balance.check("rings", mesh, GeometryCheck::kNone);
    if (report.rings.back().won == 0) break;
    report.smoothing.push_back(optimise_shape(mesh, lines, options.shape, progress));
  }
  report.invalid = invalid_faces(mesh).size();
  if (report.invalid > 0) return;  // the optimiser expects valid quads
  report.optimise = optimise_corners(mesh, lines, options.optimise, progress);
  balance.check("the corner search", mesh, GeometryCheck::kPlanarCorners);
}

}  // namespace

DualArcs find_join(const Mesh& mesh, ConstraintTags tags, const MatchingOptions& options,
                   MatchingReport& report, const Progress& progress) {
  const std::vector<float> shapes = pair_shapes(mesh, tags);
  progress.throw_if_cancelled();
  const SpanningForest forest = maximum_spanning_forest(
      mesh,
      options.start == MatchingStart::kShapes ? shapes : short_way_worths(mesh, shapes, options.short_ways));
  report.forest_rounds = forest.rounds;
  progress.throw_if_cancelled();
  DualArcs join = subtree_parity_join(mesh, forest.arcs);
  assert(is_join(mesh, join));
  if (!options.search) return join;
  progress.report("matching", 0.3);
  const MergeCosts costs(mesh, shapes, options.cost);
  improve_join(mesh, tags, costs, options.searching, join, report.search, progress);
  assert(is_join(mesh, join));
  return join;
}

void prepare_for_join(Mesh& mesh, ConstraintTags tags, const NodedLines& lines,
                      const MatchingOptions& options, MatchingReport& report, const Progress& progress) {
  const BalanceGuard balance(mesh);
  const SpanningForest forest = maximum_spanning_forest(mesh, pair_shapes(mesh, tags));
  const std::vector<SideId> odd = edges_to_halve(
      mesh, tags, forest.root, [&](SideId) { return !options.keep_boundary; }, report.parity);
  halve_edges(mesh, tags, lines, odd);
  balance.check("halved edges", mesh, GeometryCheck::kPlanarCorners);
  assert(has_even_regions(mesh, tags));
  progress.throw_if_cancelled();
  open_forced_ears(mesh, tags, options.ears, report.ears);
  balance.check("opened ears", mesh, GeometryCheck::kPlanarCorners);
  assert(has_even_regions(mesh, tags));
}

Mesh make_quads_by_matching(Mesh&& triangles, const NodedLines& lines, const MatchingOptions& options,
                            MatchingReport& report, const Progress& progress) {
  Mesh mesh = std::move(triangles);
  const BalanceGuard balance(mesh);
  progress.report("matching", 0);
  better_triangles(mesh, lines, options, report, progress);
  balance.check("flips", mesh, GeometryCheck::kPlanarCorners);
  prepare_for_join(mesh, ConstraintTags::of(mesh), lines, options, report, progress);
  const DualArcs join = find_join(mesh, ConstraintTags::of(mesh), options, report, progress);
  report.steiner_points = count_steiner_points(join);
  mesh = merge_join(std::move(mesh), join);
  balance.check("merges", mesh, GeometryCheck::kNone);
  smooth(mesh, lines, options, report, progress);
  report.quads = mesh.face_slots();
  if (options.require_valid) require_convex_quads(mesh);
  return mesh;
}

void require_convex_quads(const Mesh& mesh) {
  const std::vector<std::uint32_t> invalid = invalid_faces(mesh);
  if (invalid.empty()) return;
  const Vec2 p = mesh.point(mesh.corner(FaceId(invalid.front()), 0));
  throw Error(
      ErrorKind::kGeometry,
      fmt::format(
          "matching leaves {} quads inverted or flat, the first at {}: use --quads cluster, or clean the "
          "lines there with a larger --snap or --min-edge",
          invalid.size(), format_point(p.x, p.y)));
}

}  // namespace quarry
