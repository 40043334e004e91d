#include "surface/remesh/remesh.hpp"

#include <algorithm>
#include <cmath>

#include "engine/mesh/compact.hpp"
#include "engine/parallel/parallel.hpp"
#include "surface/model/far_points.hpp"
#include "surface/remesh/collapse_short.hpp"
#include "surface/remesh/flip_better.hpp"
#include "surface/remesh/relocate.hpp"
#include "surface/remesh/split_long.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry {
namespace {

// Each pass of splits halves what is longest: enough for edges of 2^40 wanted lengths.
constexpr int kMostSplitPasses = 80;
// What is left goes to the next round: where many edges are just as long as may be, each pass of splits and
// flips makes a few more too long, for a hundred passes.
constexpr double kFewSplits = 0.005;  // of the triangles
constexpr int kMovesEachRound = 2;
// How far the number of triangles may be from what the wanted edge asks for.
constexpr double kCountTolerance = 0.02;
constexpr int kMovesAtTheEnd = 5;
// In more places than so many it is no matter of single tips, but of a size that is too coarse for the
// surface.
constexpr std::size_t kMostLost = 24;
constexpr const char* kWantedTag = "wanted_edge";

void set_normals(RemeshState& state) {
  parallel::for_each(state.mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!state.mesh.alive(v) || !state.tags.support[v].is_free()) return;
    Vec3 sum;
    for_each_side_around(state.mesh, v, [&](SideId s) { sum = sum + state.normal_of(s.face()); });
    state.normals[v] = state.model.project({state.point(v), sum}).up;
  });
}

// How many equilateral triangles of the wanted edges have room on the mesh.
double room(const RemeshState& state) {
  const double area_of_unit = 0.25 * std::sqrt(3.0);
  return parallel::reduce_ordered(
      state.mesh.face_slots(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          if (!state.mesh.alive(FaceId(i))) continue;
          const auto corners = state.corners(FaceId(i));
          const auto p = state.points(corners);
          const double edge =
              (state.wanted[corners[0]] + state.wanted[corners[1]] + state.wanted[corners[2]]) / 3;
          sum += 0.5 * length(cross(p[1] - p[0], p[2] - p[0])) / (area_of_unit * edge * edge);
        }
        return sum;
      },
      [](double a, double b) { return a + b; });
}

// Too many triangles ask for longer edges, by no more than a tenth at a time.
double corrected(double scale, double faces, double wanted) {
  return scale * std::clamp(std::sqrt(faces / wanted), 1 / 1.1, 1.1);
}

}  // namespace

RemeshReport remesh_surface(Mesh& mesh, const SurfaceModel& model, const CurveNetwork& network,
                            const SurfaceSizes& sizes, const RemeshOptions& options,
                            const Progress& progress) {
  RemeshState state{mesh,
                    model,
                    network,
                    sizes,
                    options,
                    ConstraintTags::of(mesh),
                    mesh.add_normals(),
                    mesh.find_tag<FaceId, std::int32_t>(kSurfaceGroupTag),
                    mesh.add_tag<VertexId, double>(kWantedTag, sizes.edge())};
  for (const VertexId v : mesh.vertices()) state.wanted[v] = sizes.at(v);
  set_normals(state);
  RemeshReport report;
  for (int round = 0; round < options.rounds; ++round) {
    progress.report("remeshing", static_cast<double>(round) / options.rounds);
    std::uint64_t changes = 0;
    for (int i = 0; i < kMostSplitPasses; ++i) {
      const PassReport pass = split_long_edges(state, progress);
      const std::uint64_t splits = pass.won;
      report.splits.add(pass);
      if (splits == 0) break;
      changes += splits;
      report.flips.add(flip_edges(state, FlipAim::kMeasure, progress));
      if (static_cast<double>(splits) < kFewSplits * static_cast<double>(mesh.count_alive_faces())) break;
    }
    const PassReport collapses = collapse_short_edges(state, progress);
    report.collapses.add(collapses);
    changes += collapses.won;
    compact(mesh, EntityOrder::kHilbert);
    report.flips.add(flip_edges(state, FlipAim::kMeasure, progress));
    report.flips.add(flip_edges(state, FlipAim::kValence, progress));
    report.moves += relocate_vertices(state, kMovesEachRound, progress).moved;
    ++report.rounds;
    if (round == 0 && options.lost_from > 0) {
      report.lost = find_lost_places(mesh, model, options.lost_from, sizes.edge());
      if (report.lost.size() > kMostLost) report.lost.clear();
      if (!report.lost.empty()) {
        mesh.remove_tag<VertexId>(kWantedTag);
        return report;
      }
    }
    const double faces = static_cast<double>(mesh.count_alive_faces());
    const double wanted_faces = options.wanted_faces > 0 ? options.wanted_faces : room(state);
    if (changes == 0 && std::abs(faces - wanted_faces) < kCountTolerance * wanted_faces) break;
    state.scale = corrected(state.scale, faces, wanted_faces);
  }
  report.moves += relocate_vertices(state, kMovesAtTheEnd, progress).moved;
  report.flips.add(flip_edges(state, FlipAim::kMeasure, progress));
  mesh.remove_tag<VertexId>(kWantedTag);
  return report;
}

}  // namespace quarry
