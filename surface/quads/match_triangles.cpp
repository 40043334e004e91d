#include "surface/quads/match_triangles.hpp"

#include <utility>
#include <vector>

#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/spanning_forest.hpp"

namespace quarry {
namespace {

struct Middle {
  Vec3 place;
  Support support;
};

class SurfaceMatching {
 public:
  SurfaceMatching(Mesh&& triangles, const CurveNetwork& network, const MatchingOptions& options,
                  MatchingReport& report, const Progress& progress)
      : mesh_(std::move(triangles)),
        tags_(ConstraintTags::of(mesh_)),
        network_(network),
        options_(options),
        report_(report),
        progress_(progress) {}

  Mesh run() {
    progress_.report("matching", 0);
    make_regions_even();
    open_forced_ears(mesh_, tags_, options_.ears, report_.ears);
    const DualArcs join = find_join(mesh_, tags_, options_, report_, progress_);
    report_.steiner_points = count_steiner_points(join);
    Mesh quads = merge_join(std::move(mesh_), join);
    report_.quads = quads.face_slots();
    return quads;
  }

 private:
  void make_regions_even() {
    const SpanningForest forest = maximum_spanning_forest(mesh_, pair_shapes(mesh_, tags_));
    const auto may_halve = [&](SideId s) {
      const VertexId a = mesh_.origin(s), b = mesh_.target(s);
      return !options_.keep_boundary && network_.may_halve_outer(tags_.support[a], tags_.support[b],
                                                                 0.5 * (mesh_.point3(a) + mesh_.point3(b)));
    };
    const std::vector<SideId> odd = edges_to_halve(mesh_, tags_, forest.root, may_halve, report_.parity);
    halve_edges_at(mesh_, tags_, odd, [&](SideId s) { return middle_of(s); });
    progress_.throw_if_cancelled();
  }

  [[nodiscard]] Middle middle_of(SideId s) const {
    const VertexId a = mesh_.origin(s), b = mesh_.target(s);
    const Vec3 middle = 0.5 * (mesh_.point3(a) + mesh_.point3(b));
    const PieceId curve = network_.under_edge(tags_.support[a], tags_.support[b], middle);
    return {middle, curve.valid() ? Support::on(curve) : Support::fixed()};
  }

  Mesh mesh_;
  ConstraintTags tags_;
  const CurveNetwork& network_;
  const MatchingOptions& options_;
  MatchingReport& report_;
  const Progress& progress_;
};

}  // namespace

Mesh match_triangles(Mesh&& triangles, const CurveNetwork& network, const MatchingOptions& options,
                     MatchingReport& report, const Progress& progress) {
  return SurfaceMatching(std::move(triangles), network, options, report, progress).run();
}

}  // namespace quarry
