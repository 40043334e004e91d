#include "surface/quads/reach_far_points.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "surface/model/far_points.hpp"
#include "surface/quads/face_verdict.hpp"

namespace quarry {
namespace {

class FarPoints {
 public:
  FarPoints(Mesh& mesh, const ConstraintTags& tags, const SurfaceModel& model, const ReachOptions& options)
      : mesh_(mesh),
        tags_(tags),
        model_(model),
        options_(options),
        smoother_(model),
        normals_(mesh.normals()),
        doubtful_(model.free_points().size()),
        nearest_(model.free_points().size()) {
    std::iota(doubtful_.begin(), doubtful_.end(), 0U);
  }

  std::size_t run_round() {
    find_far();
    held_.assign(mesh_.vertex_slots(), 0);
    std::vector<VertexId> moved;
    for (const Far& far : far_)
      if (const VertexId v = reach(far); v.valid()) {
        moved.push_back(v);
        brought_.push_back(v);
        for_each_face_mate(v, [&](VertexId w) { held_[w.value()] = 1; });
        held_[v.value()] = 1;
      }
    const std::vector<VertexId> around = smooth_around(moved);
    const std::size_t brought = moved.size();
    moved.insert(moved.end(), around.begin(), around.end());
    find_doubtful(moved);
    return brought;
  }

 private:
  struct Far {
    double distance;
    std::uint32_t point;
    FaceId face;  // where the mesh is nearest
  };

  template <class Visit>
  void for_each_face_mate(VertexId v, const Visit& visit) const {
    for_each_side_around(mesh_, v, [&](SideId s) {
      for (int k = 0; k < mesh_.corner_count(s.face()); ++k) visit(mesh_.corner(s.face(), k));
    });
  }

  // What was near a face that has not changed since is so still.
  void find_far() {
    const std::vector<NearestFace> found = find_nearest_faces(mesh_, model_, doubtful_);
    far_.clear();
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto [f, distance] = found[k];
      nearest_[doubtful_[k]] = f;
      if (f.valid() && distance > options_.far * edge_of_square(mesh_, f))
        far_.push_back({distance, doubtful_[k], f});
    }
    std::stable_sort(far_.begin(), far_.end(),
                     [](const Far& a, const Far& b) { return a.distance > b.distance; });
  }

  // The far points, and those nearest to a face with a corner that has moved, or to none.
  void find_doubtful(const std::vector<VertexId>& moved) {
    std::vector<std::uint8_t> doubtful(model_.free_points().size(), 0);
    std::vector<std::uint8_t> changed(mesh_.face_slots(), 0);
    for (const Far& far : far_) doubtful[far.point] = 1;
    for (const VertexId v : moved)
      for_each_side_around(mesh_, v, [&](SideId s) { changed[s.face().value()] = 1; });
    doubtful_ = parallel::filter_indices(doubtful.size(), [&](std::size_t i) {
      return doubtful[i] != 0 || !nearest_[i].valid() || changed[nearest_[i].value()] != 0;
    });
  }

  // The free corner of the face that goes to the far point, the nearest of them that can; none if none can.
  VertexId reach(const Far& far) {
    const SpacePoint& aim = model_.free_points()[far.point];
    corners_.clear();
    for (int k = 0; k < mesh_.corner_count(far.face); ++k) {
      const VertexId v = mesh_.corner(far.face, k);
      if (tags_.support[v].is_free() && held_[v.value()] == 0)
        corners_.emplace_back(length(mesh_.point3(v) - aim.place), v);
    }
    std::sort(corners_.begin(), corners_.end());
    for (const auto& [distance, v] : corners_)
      if (bring(v, aim)) return v;
    return {};
  }

  bool bring(VertexId v, const SpacePoint& aim) {
    const SpacePoint before{mesh_.point3(v), normals_[v]};
    const double content = std::min(options_.least_jacobian, worst_around(mesh_, normals_, v));
    mesh_.set_point3(v, aim.place);
    normals_[v] = aim.up;
    if (worst_around(mesh_, normals_, v) >= content) return true;
    mesh_.set_point3(v, before.place);
    normals_[v] = before.up;
    return false;
  }

  // Two rings of free vertices around those that stay where they were brought, in this round or before;
  // returns them.
  std::vector<VertexId> smooth_around(const std::vector<VertexId>& moved) {
    std::vector<VertexId> around;
    for (const VertexId v : moved) for_each_face_mate(v, [&](VertexId w) { around.push_back(w); });
    const std::vector<VertexId> ring = around;
    for (const VertexId v : ring) for_each_face_mate(v, [&](VertexId w) { around.push_back(w); });
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::vector<VertexId> stay = brought_;
    std::sort(stay.begin(), stay.end());
    std::erase_if(around, [&](VertexId v) {
      return !tags_.support[v].is_free() || mesh_.on_boundary(v) ||
             std::binary_search(stay.begin(), stay.end(), v);
    });
    if (around.empty()) return around;
    MeshEditor editor(mesh_);
    smoother_.run(editor, around, {.untangling_sweeps = 0, .sweeps = options_.sweeps, .area_averages = 4});
    return around;
  }

  Mesh& mesh_;
  const ConstraintTags& tags_;
  const SurfaceModel& model_;
  const ReachOptions& options_;
  LocalSmoother<SpaceModel> smoother_;
  Tag<VertexId, Vec3> normals_;
  std::vector<std::uint32_t> doubtful_;  // points whose distance is not known
  std::vector<FaceId> nearest_;          // by point
  std::vector<Far> far_;
  std::vector<std::pair<double, VertexId>> corners_;  // of a face
  std::vector<VertexId> brought_;
  std::vector<std::uint8_t> held_;
};

}  // namespace

std::size_t reach_far_points(Mesh& mesh, const ConstraintTags& tags, const SurfaceModel& model,
                             const ReachOptions& options, const Progress& progress) {
  FarPoints far(mesh, tags, model, options);
  std::size_t moved = 0;
  for (int round = 0; round < options.rounds; ++round) {
    progress.throw_if_cancelled();
    const std::size_t now = far.run_round();
    if (now == 0) break;
    moved += now;
  }
  return moved;
}

}  // namespace quarry
