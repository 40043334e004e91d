#include "kernels/cluster/quads.hpp"

#include <utility>

#include "engine/mesh/balance.hpp"
#include "engine/mesh/compact.hpp"
#include "kernels/cluster/merge.hpp"

namespace quarry {

QuadOptions paper_quad_options() {
  QuadOptions options;
  options.mixed.fronts.steps = FrontOptions().steps;
  options.mixed.pairing.measure = PairMeasure::kLongestEdge;
  options.mixed.rounds = 0;
  options.smoothing.sweeps = 10;
  options.square_corners.sweeps = 0;
  return options;
}

Mesh make_mixed(Mesh&& triangles, const NodedLines& lines, const MixedOptions& options, MixedReport& report,
                const Progress& progress) {
  Mesh mesh = std::move(triangles);
  const BalanceGuard balance(mesh);
  progress.report("pairing", 0);
  align_fronts(mesh, lines, options.fronts, report.fronts, progress);
  balance.check("fronts", mesh, GeometryCheck::kPlanarCorners);
  const Pairing pairing =
      pair_triangles(mesh, ConstraintTags::of(mesh), options.pairing, report.pairing, progress);
  mesh = merge_pairs(std::move(mesh), pairing);
  balance.check("merges", mesh, GeometryCheck::kPlanarCorners);
  for (int round = 0; round < options.rounds; ++round) {
    progress.report("pairing", static_cast<double>(round + 1) / (options.rounds + 1));
    report.rearrange.push_back(rearrange(mesh, options.rearrange, progress));
    balance.check("rearranging", mesh, GeometryCheck::kPlanarCorners);
    report.smoothing.push_back(smooth_laplacian(mesh, lines, options.smoothing, progress));
    report.square_corners.push_back(square_corners(mesh, lines, options.square_corners, progress));
    balance.check("smoothing", mesh, GeometryCheck::kPlanarCorners);
  }
  return mesh;
}

Mesh make_quads(Mesh&& triangles, const NodedLines& lines, const QuadOptions& options, QuadReport& report,
                const Progress& progress) {
  const BalanceGuard balance(triangles);
  Mesh mesh = make_mixed(std::move(triangles), lines, options.mixed, report.mixed, progress);
  mesh = subdivide(std::move(mesh), lines, report.subdivide, progress);
  balance.check("halving", mesh, GeometryCheck::kPlanarCorners);
  // Sweeps go by what lies together in memory; whoever smooths later brings the mesh into that order.
  if (options.smoothing.sweeps > 0 || options.square_corners.sweeps > 0 || options.optimise.sweeps > 0)
    compact(mesh, EntityOrder::kHilbert);
  progress.report("smoothing", 0);
  report.smoothing = smooth_laplacian(mesh, lines, options.smoothing, progress);
  progress.report("smoothing", 0.2);
  report.square_corners = square_corners(mesh, lines, options.square_corners, progress);
  progress.report("smoothing", 0.8);
  report.optimise = optimise_corners(mesh, lines, options.optimise, progress);
  balance.check("smoothing", mesh, GeometryCheck::kPlanarCorners);
  return mesh;
}

}  // namespace quarry
