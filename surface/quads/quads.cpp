#include "surface/quads/quads.hpp"

#include <utility>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "engine/mesh/balance.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/local.hpp"
#include "kernels/cleanup/patch_memory.hpp"
#include "kernels/cleanup/patch_remesh.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "surface/quads/match_triangles.hpp"
#include "surface/quads/mend_faces.hpp"
#include "surface/quads/place_on_surface.hpp"
#include "surface/quads/reach_far_points.hpp"
#include "surface/quads/slide_on_features.hpp"

namespace quarry {
namespace {

// How far patches may take the number of faces from the wanted one.
constexpr double kCountTolerance = 0.035;
// At the end vertices move along features in so many rounds, so many sweeps each, the free ones between.
constexpr int kSlideRounds = 2, kSlideSweeps = 5;

class SurfaceQuads {
 public:
  SurfaceQuads(Mesh&& mesh, const SurfaceModel& model, const CurveNetwork& network,
               const SurfaceQuadOptions& options, SurfaceQuadReport& report, const Progress& progress)
      : mesh_(std::move(mesh)),
        model_(model),
        network_(network),
        options_(options),
        report_(report),
        progress_(progress) {}

  Mesh make() {
    make_quads();
    smooth(options_.first_sweeps);
    if (options_.matching) open_corners();
    return improved();
  }

  Mesh improve() {
    place();
    smooth(options_.first_sweeps);
    return improved();
  }

 private:
  Mesh improved() {
    if (options_.cleanup != CleanUpLevel::kNone) clean_up();
    slide_and_smooth();
    mend();
    report_.reached = reach_far_points(mesh_, ConstraintTags::of(mesh_), model_, options_.reach, progress_);
    return std::move(mesh_);
  }

  void make_quads() {
    const BalanceGuard balance(mesh_);
    if (options_.matching)
      mesh_ = match_triangles(std::move(mesh_), network_, *options_.matching, report_.matching, progress_);
    else
      pair_and_halve();
    balance.check("making quads", mesh_, GeometryCheck::kNone);
    place();
  }

  void place() {
    place_on_surface(mesh_, ConstraintTags::of(mesh_), model_, network_, progress_);
    compact(mesh_, EntityOrder::kHilbert);
    mend();
  }

  void pair_and_halve() {
    progress_.report("pairing", 0);
    const Pairing pairing =
        pair_triangles(mesh_, ConstraintTags::of(mesh_), options_.pairing, report_.pairing, progress_);
    mesh_ = subdivide_in_space(merge_pairs(std::move(mesh_), pairing), report_.subdivide);
    bind_middles(mesh_, ConstraintTags::of(mesh_), network_);
  }

  // Where features hold corners straight no smoothing bends them.
  void open_corners() {
    const BalanceGuard balance(mesh_);
    for (int round = 0; round < options_.matching->opening_rounds; ++round) {
      report_.matching.openings.push_back(
          open_straight_corners(mesh_, options_.matching->openings, progress_));
      if (report_.matching.openings.back().won == 0) return;
      balance.check("openings", mesh_, GeometryCheck::kNone);
      mesh_.remove_normals();
      place_on_surface(mesh_, ConstraintTags::of(mesh_), model_, network_, progress_);
      compact(mesh_, EntityOrder::kHilbert);
      smooth(options_.sweeps_between);
    }
  }

  // Few faces, if any: those that were low as soon as triangles were paired, where features leave no room.
  void mend() {
    const ConstraintTags tags = ConstraintTags::of(mesh_);
    clear_feature_normals(mesh_, tags);
    report_.turned_over = mend_faces(mesh_, tags, model_, progress_);
  }

  void clean_up() {
    progress_.report("clean-up", 0);
    add_time(report_.clean_up.local_seconds, [&] {
      open();
      report_.clean_up.local = clean_up_locally(mesh_, space(), options_.local, progress_);
      close();
    });
    if (options_.cleanup == CleanUpLevel::kLocal) return;
    smooth(options_.sweeps_between);
    const auto classes = patch_classes(options_.patches.largest, options_.cleanup == CleanUpLevel::kFewest,
                                       mesh_.count_alive_faces());
    PatchOptions patches = options_.patches;
    patches.wanted_faces = options_.wanted_faces > 0 ? options_.wanted_faces : mesh_.count_alive_faces();
    patches.most_growth = patches.most_shrinkage = kCountTolerance;
    patches.longest_edge = options_.longest_edge;
    // Nothing squares corners together here afterwards: more fills of usual sizes would cost 0.001 to 0.005
    // of the mean scaled Jacobian.
    patches.harmonic_from = patches.largest;
    patches.smoothing.smallest_move = options_.smallest_move;
    PatchMemory memory;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      progress_.report("clean-up", static_cast<double>(i + 1) / static_cast<double>(classes.size() + 1));
      patches.largest = classes[i];
      add_time(report_.clean_up.patch_seconds, [&] {
        open();
        report_.clean_up.patches.push_back(remesh_patches(mesh_, space(), patches, memory, progress_));
        close();
      });
      smooth(options_.sweeps_between);
    }
    mesh_.remove_tag<FaceId>(kSignatureTag);
  }

  void open() {
    cut_open(mesh_, ConstraintTags::of(mesh_));
    set_feature_normals(mesh_, ConstraintTags::of(mesh_));
    set_ideal_faces(mesh_, space());
  }

  // Every operation leaves tombstones, and its new entities at the end.
  void close() {
    sew(mesh_, ConstraintTags::of(mesh_));
    mesh_.remove_tag<VertexId>(kIdealTag);
    compact(mesh_, EntityOrder::kHilbert);
  }

  // All free vertices; those on features stay. No face is turned over before, and none afterwards: untangling
  // would move all of them for the sake of one.
  void smooth(int sweeps) {
    add_time(report_.clean_up.smoothing_seconds, [&] {
      const ConstraintTags tags = ConstraintTags::of(mesh_);
      clear_feature_normals(mesh_, tags);
      std::vector<VertexId> movable;
      for (const VertexId v : mesh_.vertices())
        if (mesh_.alive(v) && tags.support[v].is_free()) movable.push_back(v);
      if (movable.empty()) return;
      LocalSmoother<SpaceModel> smoother(model_);
      MeshEditor editor(mesh_);
      smoother.run(editor, movable,
                   {.untangling_sweeps = 0,
                    .sweeps = sweeps,
                    .area_averages = options_.area_averages,
                    .target = options_.target,
                    .smallest_move = options_.smallest_move});
    });
  }

  // Vertices on features and free ones in turns, at last the free ones.
  void slide_and_smooth() {
    for (int round = 0; round < kSlideRounds; ++round) {
      add_time(report_.clean_up.smoothing_seconds, [&] {
        const ConstraintTags tags = ConstraintTags::of(mesh_);
        clear_feature_normals(mesh_, tags);
        slide_on_features(mesh_, tags, network_, kSlideSweeps, progress_);
      });
      smooth(options_.last_sweeps / kSlideRounds);
    }
  }

  [[nodiscard]] const SpaceModel& space() const { return model_; }

  Mesh mesh_;
  const SurfaceModel& model_;
  const CurveNetwork& network_;
  const SurfaceQuadOptions& options_;
  SurfaceQuadReport& report_;
  const Progress& progress_;
};

}  // namespace

Mesh make_surface_quads(Mesh&& triangles, const SurfaceModel& model, const CurveNetwork& network,
                        const SurfaceQuadOptions& options, SurfaceQuadReport& report,
                        const Progress& progress) {
  return SurfaceQuads(std::move(triangles), model, network, options, report, progress).make();
}

Mesh improve_surface_quads(Mesh&& mesh, const SurfaceModel& model, const CurveNetwork& network,
                           const SurfaceQuadOptions& options, SurfaceQuadReport& report,
                           const Progress& progress) {
  return SurfaceQuads(std::move(mesh), model, network, options, report, progress).improve();
}

}  // namespace quarry
