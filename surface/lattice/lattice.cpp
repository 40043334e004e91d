#include "surface/lattice/lattice.hpp"

#include "engine/base/stopwatch.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/parallel/parallel.hpp"
#include "surface/lattice/join_shared.hpp"
#include "surface/lattice/lattice_fields.hpp"
#include "surface/lattice/snap.hpp"
#include "surface/remesh/collapse_short.hpp"
#include "surface/remesh/flip_better.hpp"
#include "surface/remesh/relocate.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry {
namespace {

constexpr const char* kWantedTag = "wanted_edge";
constexpr const char* kPlaceTag = "lattice_place";
constexpr const char* kAlongTag = "lattice_along";

void set_spacing(RemeshState& state) {
  if (state.sizes.uniform()) return;
  parallel::for_each(state.mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (state.mesh.alive(v))
      state.wanted[v] = state.sizes.at(state.model.nearest({state.point(v), state.normals[v]}));
  });
}

}  // namespace

LatticeReport make_lattice(Mesh& mesh, const SurfaceModel& model, const CurveNetwork& network,
                           const SurfaceSizes& spacing, const LatticeOptions& options,
                           const Progress& progress) {
  LatticeReport report;
  const RemeshOptions remesh{.longest = options.longest,
                             .shortest = options.shortest,
                             .feature_deviation = options.feature_deviation};
  RemeshState base{mesh,
                   model,
                   network,
                   spacing,
                   remesh,
                   ConstraintTags::of(mesh),
                   mesh.normals(),
                   mesh.find_tag<FaceId, std::int32_t>(kSurfaceGroupTag),
                   mesh.add_tag<VertexId, double>(kWantedTag, spacing.edge())};
  set_spacing(base);
  LatticeState state{base, mesh.add_tag<VertexId, Vec3>(kPlaceTag), mesh.add_tag<VertexId, Vec3>(kAlongTag)};
  progress.report("finding a lattice", 0);
  find_lattice_fields(state, options, report, progress);
  const Stopwatch watch;
  report.joins.add(join_shared_points(state, options.lowest_joined, progress));
  compact(mesh, EntityOrder::kHilbert);
  for (int round = 0; round < options.rounds; ++round) {
    report.moves += snap_to_lattice(state, options.sweeps, options.content, progress).moved;
    report.flips.add(flip_edges(base, FlipAim::kMeasure, progress));
    report.joins.add(join_shared_points(state, options.lowest_joined, progress));
  }
  for (int round = 0; round < options.repair_rounds; ++round) {
    report.collapses.add(collapse_short_edges(base, progress));
    const std::uint64_t moved = relocate_below(base, options.content, options.sweeps, progress).moved;
    const PassReport flips = flip_edges(base, FlipAim::kMeasure, progress);
    report.flips.add(flips);
    report.repairs += moved + flips.won;
    if (moved + flips.won == 0) break;
  }
  for (const char* name : {kPlaceTag, kAlongTag, kWantedTag}) mesh.remove_tag<VertexId>(name);
  compact(mesh, EntityOrder::kHilbert);
  report.change_seconds = watch.seconds();
  return report;
}

}  // namespace quarry
